/** Which pixels hold an outline: where two rays through the same pixel may see different surfaces. */
package raytracing.outline;
