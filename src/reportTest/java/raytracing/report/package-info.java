/** The arithmetic of the report, on figures and pictures made up by hand. */
package raytracing.report;
