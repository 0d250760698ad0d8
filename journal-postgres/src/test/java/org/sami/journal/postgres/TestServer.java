package org.sami.journal.postgres;

import io.zonky.test.db.postgres.embedded.EmbeddedPostgres;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.sql.Connection;
import java.sql.DriverManager;
import java.sql.ResultSet;
import java.sql.SQLException;
import java.sql.Statement;
import java.time.Duration;
import java.util.concurrent.atomic.AtomicInteger;

/** One PostgreSQL server for all tests of this module; each test has a schema of its own in it. It ends with the process. */
final class TestServer {
    /** Where the server's programs are unpacked; a clean build has it gone. */
    private static final Path PROGRAMS = Path.of("build", "postgres").toAbsolutePath();

    private static final AtomicInteger SCHEMAS = new AtomicInteger();

    private TestServer() {}

    private static final class Shared {
        static final EmbeddedPostgres SERVER = start();
    }

    static EmbeddedPostgres start() {
        try {
            return builder().start();
        } catch (IOException fault) {
            throw new UncheckedIOException(fault);
        }
    }

    /** A server of its own, for tests that end it. */
    static EmbeddedPostgres.Builder builder() {
        return EmbeddedPostgres.builder()
                .setOverrideWorkingDirectory(PROGRAMS.toFile())
                .setPGStartupWait(Duration.ofMinutes(2));
    }

    /** The address of a schema that is not there yet. */
    static String address() {
        return address(Shared.SERVER.getPort());
    }

    static String address(int port) {
        return "postgresql://localhost:" + port + "/postgres?user=postgres&schema=s" + SCHEMAS.incrementAndGet();
    }

    static int port() {
        return Shared.SERVER.getPort();
    }

    /** Does something to the tables of an address as another program would. */
    static void run(String address, String sql) throws SQLException {
        try (Connection connection = connect(address);
                Statement statement = connection.createStatement()) {
            statement.execute(sql);
        }
    }

    static long number(String address, String sql) throws SQLException {
        try (Connection connection = connect(address);
                Statement statement = connection.createStatement();
                ResultSet rows = statement.executeQuery(sql)) {
            rows.next();
            return rows.getLong(1);
        }
    }

    static Connection connect(String address) throws SQLException {
        PostgresAddress parsed = PostgresAddress.parse(address);
        return DriverManager.getConnection(parsed.url(), parsed.properties());
    }
}
