/**
 * Benchmarks of a served session, run by {@code ./gradlew benchmark}: what fronts cost its host, and what reaches them.
 *
 * <p>Belongs here: measurements and the main program that writes their table and file. Does not belong here: tests.
 */
package org.sami.session.server.bench;
