/**
 * What a front may see of a session, ask of it and do in it, wherever the session runs: {@link FrontSession} with its boats, and the values in
 * which it answers.
 *
 * <p>Not here: a session ({@code org.sami.crw.session}), how one elsewhere is reached ({@code org.sami.session.client}), and the models in which
 * fronts see it ({@code org.sami.crw.operator}).
 */
@NullMarked
package org.sami.session.api;

import org.jspecify.annotations.NullMarked;
