/**
 * How windows look: the theme in force and its look, fonts and their scale, spacing, icons. Colours are those of {@code org.sami.palette}. No
 * other package of a window names a colour or a font size of its own.
 */
@NullMarked
package org.sami.ui.look;

import org.jspecify.annotations.NullMarked;
