/**
 * The view of a plan's net in windows, for watching missions and for writing plans.
 *
 * <p>Belongs here: the part of the net that is seen, pointer, keys, tools, tooltips and the pulse of firing. Does not belong here: what of a net
 * is shown and how it is painted ({@link org.sami.picture.net}), where things lie and what is written ({@link org.sami.spn.drawing}), and
 * what an edit does.
 */
@NullMarked
package org.sami.ui.net;

import org.jspecify.annotations.NullMarked;
