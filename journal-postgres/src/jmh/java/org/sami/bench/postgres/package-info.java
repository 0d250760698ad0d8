/**
 * Measurements of journals in PostgreSQL, run by {@code ./gradlew :journal-postgres:benchmark}.
 *
 * <p>Belongs here: measurements and the main program that writes their table and file. Does not belong here: tests.
 */
package org.sami.bench.postgres;
