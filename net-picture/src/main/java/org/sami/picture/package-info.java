/**
 * What pictures are painted on: a {@link org.sami.picture.Canvas}, as pixels, as SVG, or as whatever else somebody writes, and the fonts of nets. Needs no display.
 *
 * <p>What is painted of a net belongs to {@code org.sami.picture.net}; windows and what a mouse does do not belong here.
 */
@NullMarked
package org.sami.picture;

import org.jspecify.annotations.NullMarked;
