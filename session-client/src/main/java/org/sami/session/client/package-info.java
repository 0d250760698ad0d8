/**
 * A session that runs in another process, as fronts here see it: the link to its server (docs/session-link.md), and models that follow it. What fronts may do stands in
 * {@link org.sami.session.api.FrontSession}; how a session is served belongs to {@code org.sami.session.server}.
 */
@NullMarked
package org.sami.session.client;

import org.jspecify.annotations.NullMarked;
