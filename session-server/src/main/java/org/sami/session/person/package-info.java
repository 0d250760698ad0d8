/**
 * The people of a session that several share: their keys, roles and rights, and the file that lists them. Knows no session and no network.
 */
@NullMarked
package org.sami.session.person;

import org.jspecify.annotations.NullMarked;
