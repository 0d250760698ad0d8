/**
 * Pictures that cameras took, read from files of which nothing is known: within bounds of bytes and pixels, scaled while they are decoded. Needs no display.
 *
 * <p>Not here: where such files come from, and drawings of our own.
 */
@NullMarked
package org.sami.picture.photo;

import org.jspecify.annotations.NullMarked;
