/**
 * Tests of the whole: the module map, the borders between packages, and what no source may contain. Here belongs what
 * concerns more than one module; what one module promises of itself is tested in that module.
 */
package org.sami.architecture;
