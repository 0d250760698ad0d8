package org.sami.pair.postgres;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.sql.Connection;
import java.sql.SQLException;
import java.util.List;
import org.postgresql.util.PasswordUtil;
import org.sami.journal.postgres.Connections;
import org.sami.journal.postgres.DatabaseFaults;
import org.sami.journal.postgres.PairSetting;

/** Makes the databases of a pair: the first, its replica, and the replica anew. For one thread. */
public final class PairSetup {
    private static final int MAKE_SECONDS = 60;
    private static final int COPY_SECONDS = 1800;

    /** What both bases set, in the file that a copy takes along. Times are short, so that a cut shows before a lease ends. */
    private static final String SETTINGS = """

        # Of a pair of bases (SAMI)
        unix_socket_directories = ''
        ssl = on
        ssl_cert_file = '../pair.crt'
        ssl_key_file = '../pair.key'
        wal_keep_size = 1GB
        client_connection_check_interval = 2s
        max_wal_senders = 6
        wal_sender_timeout = 1500ms
        wal_receiver_timeout = 2s
        wal_receiver_status_interval = 1s
        wal_retrieve_retry_interval = 500ms
        hot_standby_feedback = on
        max_standby_streaming_delay = 1s
        shared_buffers = 64MB
        """;

    /** Over a link that loses packets a copy may stand still for longer than a replica may be silent. */
    private static final String PATIENTLY = " options='-c wal_sender_timeout=60s'";

    private final PairFolder folder;
    private final Programs programs;
    private final PairSettings settings;
    private final PairDatabase database;

    private PairSetup(PairFolder folder, Programs programs, PairSettings settings) {
        this.folder = folder;
        this.programs = programs;
        this.settings = settings;
        this.database = new PairDatabase(folder, programs, settings);
    }

    /**
     * Makes and starts the database of a new pair; nothing is left where it fails.
     *
     * @throws PairException if there is a pair in the folder, or PostgreSQL refuses
     */
    public static PairDatabase make(PairFolder folder, Programs programs, PairSettings settings, PairSecrets secrets)
            throws IOException {
        PairSetup setup = begun(folder, programs, settings, secrets);
        try {
            setup.initialize(secrets);
            setup.database.start();
            setup.makeRoles(secrets);
            return setup.database;
        } catch (IOException | RuntimeException fault) {
            setup.undo();
            throw fault;
        }
    }

    /**
     * Makes and starts the replica of the other base's database; nothing is left where it fails.
     *
     * @throws PairException if there is a pair in the folder, or the other base is not reached
     */
    public static PairDatabase join(PairFolder folder, Programs programs, Invitation invitation) throws IOException {
        PairSetup setup = begun(folder, programs, invitation.settings(), invitation.secrets());
        try {
            setup.copyFromOther(folder.data());
            setup.database.start();
            return setup.database;
        } catch (IOException | RuntimeException fault) {
            setup.undo();
            throw fault;
        }
    }

    private static PairSetup begun(PairFolder folder, Programs programs, PairSettings settings, PairSecrets secrets)
            throws IOException {
        if (folder.isThere()) {
            throw new PairException(folder.path()
                    + " holds a pair already; 'crw pair status' says which, 'crw pair leave' gives it up");
        }
        if (!folder.isFree()) {
            throw new PairException(folder.path() + " is not empty: a pair needs a folder of its own");
        }
        folder.write(settings, secrets, programs.folder());
        return new PairSetup(folder, programs, settings);
    }

    private void undo() {
        try {
            database.delete();
        } catch (IOException left) {
            System.getLogger(PairSetup.class.getName())
                    .log(System.Logger.Level.WARNING, "{0} was left: {1}", folder.path(), left.getMessage());
        }
    }

    private void initialize(PairSecrets secrets) throws IOException {
        Path password = folder.path().resolve("admin.tmp");
        PrivateFile.write(password, secrets.admin() + "\n");
        try {
            run(
                    "the database cannot be made",
                    MAKE_SECONDS,
                    List.of(
                            "initdb",
                            "--pgdata=" + folder.data(),
                            "--username=" + Roles.ADMIN,
                            "--pwfile=" + password,
                            "--auth=scram-sha-256",
                            "--encoding=UTF8",
                            "--locale=C",
                            "--data-checksums"));
        } finally {
            Files.deleteIfExists(password);
        }
        Files.writeString(folder.data().resolve("postgresql.conf"), SETTINGS, StandardOpenOption.APPEND);
        new AccessList(folder.data()).write(settings);
    }

    private void makeRoles(PairSecrets secrets) throws IOException {
        PairConnections connections = new PairConnections(folder, settings);
        try {
            try (Connection admin = connections.asAdmin("postgres")) {
                Connections.run(
                        admin,
                        "CREATE ROLE " + Roles.SESSION + " LOGIN PASSWORD '"
                                + verifier(Roles.SESSION, secrets.session()) + "' IN ROLE pg_monitor");
                Connections.run(
                        admin,
                        "CREATE ROLE " + Roles.REPLICA + " LOGIN REPLICATION PASSWORD '"
                                + verifier(Roles.REPLICA, secrets.replica()) + "'");
                Connections.run(admin, "CREATE DATABASE " + Roles.DATABASE + " OWNER " + Roles.SESSION);
                Connections.run(
                        admin,
                        "ALTER DATABASE " + Roles.DATABASE + " SET " + PairSetting.NAME + " = '"
                                + settings.whenCut().text() + "'");
                Connections.run(admin, "GRANT ALTER SYSTEM ON PARAMETER synchronous_standby_names TO " + Roles.SESSION);
            }
            try (Connection admin = connections.asAdmin(Roles.DATABASE)) {
                Connections.run(admin, "GRANT EXECUTE ON FUNCTION pg_reload_conf() TO " + Roles.SESSION);
                Connections.run(admin, "GRANT EXECUTE ON FUNCTION pg_promote(boolean, integer) TO " + Roles.SESSION);
            }
            try (Connection session = connections.own()) {
                StandbySign.makeTable(session);
            }
        } catch (SQLException fault) {
            throw new PairException("the database cannot be set up: " + DatabaseFaults.words(fault), fault);
        }
    }

    /** What the database keeps of a password: a statement that fails stands in its log. */
    private static String verifier(String role, String password) throws SQLException {
        return PasswordUtil.encodePassword(role, password.toCharArray(), "scram-sha-256");
    }

    /** Copies the other base's database as it is now into a folder that is not there, as its replica. */
    private void copyFromOther(Path data) throws IOException {
        PairConnections connections = new PairConnections(folder, settings);
        run(
                "the database of " + settings.other() + " cannot be copied",
                COPY_SECONDS,
                List.of(
                        "pg_basebackup",
                        "--dbname=" + connections.source() + PATIENTLY,
                        "--pgdata=" + data,
                        "--wal-method=stream",
                        "--checkpoint=fast"));
        Files.writeString(
                data.resolve("postgresql.auto.conf"),
                Replication.SOURCE + " = '" + connections.sourceOfReplica().replace("'", "''") + "'\n");
        Files.writeString(data.resolve("standby.signal"), "");
    }

    /**
     * Makes this base's database anew as the replica of the other's. The database that it had is kept beside it, as it was.
     *
     * @param suffix of the folder in which it is kept
     * @return where the earlier database is
     */
    public static Path copyAgain(PairFolder folder, String suffix) throws IOException {
        return new PairSetup(folder, Programs.of(folder), folder.settings()).copyAgain(suffix);
    }

    private Path copyAgain(String suffix) throws IOException {
        Path anew = folder.path().resolve("data.new");
        PairFolder.delete(anew);
        try {
            copyFromOther(anew);
        } catch (IOException fault) {
            PairFolder.delete(anew);
            throw fault;
        }
        if (database.isRunning()) {
            database.stop();
        }
        Path kept = folder.path().resolve("data." + suffix);
        Files.move(folder.data(), kept);
        Files.move(anew, folder.data());
        database.start();
        return kept;
    }

    private void run(String what, int seconds, List<String> command) throws IOException {
        programs.run(what, folder.passwords(), seconds, command);
    }
}
