package org.sami.pair.postgres;

import java.net.URLEncoder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.sql.Connection;
import java.sql.DriverManager;
import java.sql.SQLException;
import java.util.Properties;
import org.sami.journal.postgres.PostgresAddress;

/** Addresses of, and connections to, the databases of a pair. Answers come within seconds, or none. */
final class PairConnections {
    private static final int ANSWER_SECONDS = 3;

    private final PairFolder folder;
    private volatile PairSettings known;

    /** Of a pair. */
    PairConnections(PairFolder folder, PairSettings settings) {
        this.folder = folder;
        this.known = settings;
    }

    /** How this base sees the pair now: a person may have changed addresses since the last connection. The earlier ones where the folder is gone. */
    PairSettings settings() {
        try {
            known = folder.settings();
        } catch (PairException gone) {
            System.getLogger(PairConnections.class.getName())
                    .log(System.Logger.Level.DEBUG, "the settings of a pair: {0}", gone.getMessage());
        }
        return known;
    }

    /** Where a session of this base has its journal. */
    PostgresAddress journal(String schema) {
        return PostgresAddress.parse(here(Roles.DATABASE, Roles.SESSION) + "&schema=" + encoded(schema));
    }

    /** The same journal in the other base's database. */
    PostgresAddress otherJournal(String schema) {
        return PostgresAddress.parse(there(settings()) + "&schema=" + encoded(schema));
    }

    /** To this base's database. */
    Connection own() throws SQLException {
        return own(ANSWER_SECONDS);
    }

    /** The same, where an answer may take longer. */
    Connection own(int answerSeconds) throws SQLException {
        return connect(PostgresAddress.parse(here(Roles.DATABASE, Roles.SESSION)), answerSeconds);
    }

    /** To the other base's database. */
    Connection other() throws SQLException {
        return other(settings());
    }

    /** The same, where a pair has these addresses. */
    Connection other(PairSettings settings) throws SQLException {
        return connect(PostgresAddress.parse(there(settings)), ANSWER_SECONDS);
    }

    Connection asAdmin(String database) throws SQLException {
        return connect(PostgresAddress.parse(here(database, Roles.ADMIN)), ANSWER_SECONDS * 10);
    }

    /** The other base's database, in the words by which PostgreSQL's programs connect. */
    String source() {
        PairSettings settings = settings();
        return "host=" + settings.other() + " port=" + settings.port() + " user=" + Roles.REPLICA
                + " sslmode=verify-ca sslrootcert=" + quoted(folder.certificate()) + " passfile="
                + quoted(folder.passwords()) + " connect_timeout=5";
    }

    /** The same for a replica that follows it. */
    String sourceOfReplica() {
        return source() + " application_name=" + StandbySign.NAME;
    }

    private static String quoted(Path value) {
        return "'" + value.toString().replace("\\", "\\\\").replace("'", "\\'") + "'";
    }

    private String here(String database, String role) {
        PairSettings settings = settings();
        return "postgresql://" + bracketed(settings.loopback()) + ":" + settings.port() + "/" + database + "?user="
                + role + "&passfile=" + encoded(folder.passwords().toString());
    }

    private String there(PairSettings settings) {
        return "postgresql://" + bracketed(settings.other()) + ":" + settings.port() + "/" + Roles.DATABASE + "?user="
                + Roles.SESSION + "&passfile=" + encoded(folder.passwords().toString())
                + "&sslmode=verify-ca&sslrootcert="
                + encoded(folder.certificate().toString());
    }

    private static String bracketed(String host) {
        return host.contains(":") ? "[" + host + "]" : host;
    }

    private static Connection connect(PostgresAddress address, int answerSeconds) throws SQLException {
        Properties properties = address.properties();
        properties.setProperty("ApplicationName", "sami-pair");
        properties.setProperty("connectTimeout", Integer.toString(ANSWER_SECONDS));
        properties.setProperty("socketTimeout", Integer.toString(answerSeconds));
        // what a base says of the pair must reach its own disk alone
        properties.setProperty("options", "-c synchronous_commit=local -c search_path=pair");
        return DriverManager.getConnection(address.url(), properties);
    }

    private static String encoded(String text) {
        return URLEncoder.encode(text, StandardCharsets.UTF_8);
    }
}
