/**
 * In which rows a session tells what happens next to its engine's inputs: poses, links, messages, readings, pictures. Its journal keeps them, and
 * whoever shows the session later or elsewhere reads them.
 *
 * <p>Not here: where a session keeps them ({@code org.sami.crw.session.archive}).
 */
@NullMarked
package org.sami.session.record;

import org.jspecify.annotations.NullMarked;
