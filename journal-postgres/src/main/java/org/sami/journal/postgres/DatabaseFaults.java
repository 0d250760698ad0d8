package org.sami.journal.postgres;

import java.net.ConnectException;
import java.net.SocketTimeoutException;
import java.net.UnknownHostException;
import java.sql.SQLException;
import java.util.Map;
import org.sami.spn.host.JournalException;

/** What faults of PostgreSQL mean, in words; by their codes (SQLSTATE), the classes of codes last. */
public final class DatabaseFaults {
    private static final Map<String, String> WORDS = Map.ofEntries(
            Map.entry("53100", "the disk of the database is full"),
            Map.entry("53200", "the database is out of memory"),
            Map.entry("53300", "the database has too many connections"),
            Map.entry("55P03", "another program locks its tables"),
            Map.entry("57014", "the database takes too long"),
            Map.entry("57P01", "the database shuts down"),
            Map.entry("57P02", "the database crashed"),
            Map.entry("57P03", "the database is starting or shutting down"),
            Map.entry("23505", "another program has written it already"),
            Map.entry("25P03", "the database ended a transaction that stood still"),
            Map.entry("25006", "the database is read only: it may be a standby"),
            Map.entry("3D000", "there is no such database"),
            Map.entry("42501", "the database's user may not do this"),
            Map.entry("42P01", "a table is missing"),
            Map.entry(
                    "28P01",
                    "the database refuses the password; it is looked for in ~/.pgpass, or in the file that PGPASSFILE"
                            + " names"),
            Map.entry("28000", "the database refuses this user"),
            Map.entry("58030", "the disk of the database does not take it"),
            Map.entry("08", "the database cannot be reached"),
            Map.entry("53", "the database has no resources left"),
            Map.entry("58", "the database's machine does not work"),
            Map.entry("XX", "the database is damaged"));

    private DatabaseFaults() {}

    /** Why the database refused a statement. */
    public static String words(SQLException fault) {
        for (Throwable cause = fault; cause != null; cause = cause.getCause()) {
            if (cause instanceof UnknownHostException) {
                return "there is no such host";
            }
            if (cause instanceof ConnectException) {
                return "no database answers there";
            }
            if (cause instanceof SocketTimeoutException) {
                return "the database does not answer in time";
            }
        }
        String code = String.valueOf(fault.getSQLState());
        String said = String.valueOf(fault.getMessage());
        if (said.contains("no password was provided")) { // the driver's, under the code of a lost connection
            code = "28P01";
        }
        String known = WORDS.get(code);
        if (known == null && code.length() > 2) {
            known = WORDS.get(code.substring(0, 2));
        }
        return known == null ? said : known;
    }

    /** A fault of a journal. */
    static JournalException of(PostgresAddress address, long entry, String what, SQLException fault) {
        return new JournalException(address.words(), entry, what + ": " + words(fault), fault);
    }
}
