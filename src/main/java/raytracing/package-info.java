/** The front door. Each room behind it imports only from those before it: see {@code src/docs/DECISIONS.md}. */
package raytracing;
