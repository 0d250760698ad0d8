/** A served session for tests of this module and of those that are its fronts. Nothing that a program needs. */
package org.sami.session.server.testing;
