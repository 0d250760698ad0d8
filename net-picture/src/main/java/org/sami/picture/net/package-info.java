/**
 * The picture of a net: what of it is shown, with tokens, firing and selection, and how that is painted. Windows and files have the same painter; a theme says
 * in which colours. Needs no display.
 *
 * <p>Does not belong here: where things lie and what is written ({@link org.sami.spn.drawing}); what a mouse does.
 */
@NullMarked
package org.sami.picture.net;

import org.jspecify.annotations.NullMarked;
