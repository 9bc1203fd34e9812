/* The conformance program for targets without files: no arguments, a report, an exit status. */
#include "conform_report.h"
#include "port.h"

int main(void)
{
    const int status = lobe_conform_report(1);
    lobe_port_exit(status);
    return status;
}
