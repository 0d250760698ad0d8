/**
 * How the pictures of boats come into a session: they are fetched by themselves after each panorama, within bounds, and kept in a folder next to the journal.
 *
 * <p>Not here: the links on which they come ({@code org.sami.crw.proxy.file}), and how they are shown.
 */
@NullMarked
package org.sami.crw.session.picture;

import org.jspecify.annotations.NullMarked;
