/**
 * Colours by what they mean, in each theme, and the colour and shape of each proxy: the same in windows, pictures and reports.
 *
 * <p>Belongs here: values of colours. Does not belong here: fonts, spacing and everything else of a window's look ({@code org.sami.ui.look}).
 */
@NullMarked
package org.sami.palette;

import org.jspecify.annotations.NullMarked;
