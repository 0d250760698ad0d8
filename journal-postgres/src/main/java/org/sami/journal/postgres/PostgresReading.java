package org.sami.journal.postgres;

import java.sql.Connection;
import java.sql.SQLException;
import java.util.Optional;
import org.sami.spn.host.JournalException;
import org.sami.spn.journal.JournalPart;
import org.sami.spn.journal.JournalReader;

/** Readers of journals in PostgreSQL. */
final class PostgresReading {
    private PostgresReading() {}

    /**
     * Opens one.
     *
     * @param known what was read before, and is not read again
     * @throws JournalException if there is none, or it cannot be read
     */
    static JournalReader open(PostgresAddress address, Optional<JournalPart> known) throws JournalException {
        return open(address, known, Connections::toRead);
    }

    /** The same for whoever looks again and again: gives up soon where nothing answers. */
    static JournalReader follow(PostgresAddress address, JournalPart known) throws JournalException {
        return open(address, Optional.of(known), Connections::toFollow);
    }

    @FunctionalInterface
    private interface Opening {
        Connection open(PostgresAddress address) throws SQLException;
    }

    private static JournalReader open(PostgresAddress address, Optional<JournalPart> known, Opening opening)
            throws JournalException {
        try {
            Connection connection = opening.open(address);
            try {
                if (!Migrations.isThere(connection, address)) {
                    throw new JournalException(address.words(), 0, "is not there");
                }
                Migrations.version(connection, address);
                return JournalReader.over(address.words(), connection, known);
            } catch (SQLException | JournalException | RuntimeException fault) {
                Connections.drop(connection);
                throw fault;
            }
        } catch (SQLException fault) {
            throw DatabaseFaults.of(address, 0, "cannot be read", fault);
        }
    }
}
