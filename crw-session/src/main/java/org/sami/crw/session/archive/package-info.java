/**
 * What a session keeps: its journal's rows and streams, what boats reported, where they were, and what the next session is to know.
 *
 * <p>Not here: the engine's journal itself ({@code org.sami.spn.journal}), and how a kept session is shown ({@code org.sami.crw.replay}).
 */
@NullMarked
package org.sami.crw.session.archive;

import org.jspecify.annotations.NullMarked;
