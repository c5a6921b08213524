/** What the words of a command line ask for. */
package raytracing.command;
