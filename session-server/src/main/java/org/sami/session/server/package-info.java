/**
 * Serves a session to several people: connections, logins, commands with their rights, the page (docs/session-link.md). How people are kept belongs to
 * {@code org.sami.session.person}, the form of rows to {@code org.sami.session.rows}, what commands do to {@code org.sami.crw.session}.
 */
@NullMarked
package org.sami.session.server;

import org.jspecify.annotations.NullMarked;
