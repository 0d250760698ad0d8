/**
 * The net of a plan, on JUNG, for watching missions and for writing plans.
 *
 * <p>Belongs here: what of a net is shown and how it is painted, with tokens, firing and selection; {@link org.sami.ui.net.NetScene} and
 * {@link org.sami.ui.net.NetMarking} know no Swing. Does not belong here: where things lie and what is written
 * ({@link org.sami.spn.drawing}), and what an edit does.
 */
package org.sami.ui.net;
