/** Fronts of served sessions for tests of this module and of programs. Nothing that a program needs. */
package org.sami.session.client.testing;
