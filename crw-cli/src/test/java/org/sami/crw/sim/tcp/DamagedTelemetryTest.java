package org.sami.crw.sim.tcp;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.io.RandomAccessFile;
import java.io.UncheckedIOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.sql.Connection;
import java.sql.DriverManager;
import java.sql.ResultSet;
import java.sql.Statement;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.sami.boat.link.StartWaypoints;
import org.sami.boat.link.SteadyClock;
import org.sami.boat.server.log.LogLines;
import org.sami.boat.server.log.LoggedCommand;
import org.sami.boat.server.tcp.TcpServerListener;
import org.sami.boat.server.testing.Await;
import org.sami.boat.server.testing.ProcessClock;
import org.sami.crw.cli.CommandResult;
import org.sami.crw.cli.CrwProcess;
import org.sami.crw.sim.boat.BoatOnTcp;
import org.sami.crw.sim.boat.BoatSettings;
import org.sami.spn.journal.JournalOptions;
import org.sami.spn.journal.SqliteJournal;
import org.sami.spn.value.GeoPoint;

/** Journals of real runs whose telemetry is damaged on the disk: what the engine knows is what matters, and the mission goes on. */
@Tag("process")
@Timeout(900)
class DamagedTelemetryTest {
    private static final ObjectMapper JSON = new ObjectMapper();
    private static final int PAGE = JournalOptions.DEFAULT.pageBytes();

    @TempDir
    private Path folder;

    /** What befalls a journal's file. */
    private interface Damage {
        void in(Path journal) throws Exception;
    }

    @Test
    @Execution(ExecutionMode.CONCURRENT)
    void missionGoesOnAfterABitOfAPoseWasFlipped() throws Exception {
        assertGoesOnAfter("damaged and left out", journal -> {
            byte[] bytes = Files.readAllBytes(journal);
            bytes[firstPose(journal, bytes)] ^= 1;
            Files.write(journal, bytes);
        });
    }

    /**
     * Where the first pose stands in the file. A page is filled from its end; what stands before its rows can be left over from rows that were
     * moved, and belongs to none.
     */
    private static int firstPose(Path journal, byte[] bytes) throws Exception {
        String text = new String(bytes, StandardCharsets.ISO_8859_1);
        for (int page : pages(journal)) {
            int at = text.lastIndexOf("\"headingRad\"", page * PAGE - 1);
            if (at >= (page - 1) * PAGE) {
                return at;
            }
        }
        throw new AssertionError("no pose is in the telemetry of " + journal);
    }

    @Test
    @Execution(ExecutionMode.CONCURRENT)
    void missionGoesOnAfterTheFirstPageOfTelemetryWasDamaged() throws Exception {
        assertGoesOnAfter(
                "telemetry: where the area lies is lost",
                journal -> zero(journal, pages(journal).get(0)));
    }

    @Test
    @Execution(ExecutionMode.CONCURRENT)
    void missionGoesOnAfterAllTelemetryWasLost() throws Exception {
        assertGoesOnAfter("telemetry: where the area lies is lost", DamagedTelemetryTest::empty);
    }

    @Test
    @Execution(ExecutionMode.CONCURRENT)
    void runThatIsOverIsToldAgainWhicheverPageOfTelemetryIsDamaged() throws Exception {
        Path journal = folder.resolve("over.journal");
        String firings;
        try (BoatOnTcp anna = boat("anna", 10.9)) {
            CommandResult ran =
                    CommandResult.crw(mission(journal, List.of(anna)).toArray(String[]::new));
            assertThat(ran.exitCode()).as(ran.err()).isZero();
            firings = JSON.readTree(ran.out()).path("firings").asText();
        }
        List<Integer> pages = pages(journal);
        assertThat(pages).isNotEmpty();
        for (int page : pages) {
            Path copy = Files.copy(journal, folder.resolve("page" + page + ".journal"));
            zero(copy, page);

            CommandResult told = CommandResult.crw("resume", copy.toString(), "--json");

            assertThat(told.exitCode()).as(told.err()).isZero();
            assertThat(told.err()).contains("telemetry: ", "left out", "this run was over already");
            assertThat(JSON.readTree(told.out()).path("firings").asText()).isEqualTo(firings);
        }
        empty(journal);
        assertThat(CommandResult.crw("resume", journal.toString(), "--json").exitCode())
                .isZero();
    }

    private void assertGoesOnAfter(String named, Damage damage) throws Exception {
        Path journal = folder.resolve("run.journal");
        try (BoatOnTcp anna = boat("anna", 10.9);
                BoatOnTcp bert = boat("bert", 10.9001)) {
            try (CrwProcess run = CrwProcess.start(folder, mission(journal, List.of(anna, bert)))) {
                Await.until("anna is under way", this::isAnnaUnderWay);
                run.kill();
            }
            SqliteJournal.open(journal, JournalOptions.DEFAULT).close(); // folds its log into one file
            damage.in(journal);

            CommandResult resumed = CommandResult.crw("resume", journal.toString(), "--json", "--for", "150");

            assertThat(resumed.exitCode()).as(resumed.err()).isZero();
            assertThat(resumed.err()).contains(named);
            JsonNode report = JSON.readTree(resumed.out());
            assertThat(report.path("outcome").asText()).isEqualTo("ended");
            assertThat(report.path("locationsVisited").asInt()).isPositive();
            CommandResult again = CommandResult.crw("resume", journal.toString(), "--json");
            assertThat(again.exitCode()).as(again.err()).isZero();
        }
    }

    private boolean isAnnaUnderWay() {
        List<LoggedCommand> commands = new ArrayList<>();
        try {
            LogLines.read(folder.resolve("anna.log"), commands::add);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return commands.stream().anyMatch(entry -> entry.command() instanceof StartWaypoints);
    }

    private BoatOnTcp boat(String name, double lonDeg) throws Exception {
        InetSocketAddress anyPort = new InetSocketAddress(InetAddress.getLoopbackAddress(), 0);
        BoatSettings settings =
                BoatSettings.of(name, anyPort, GeoPoint.of(45.4, lonDeg), 1).loggingTo(folder);
        return new BoatOnTcp(settings, new SteadyClock(ProcessClock::ms), TcpServerListener.NONE);
    }

    private static List<String> mission(Path journal, List<BoatOnTcp> boats) {
        List<String> addresses = new ArrayList<>();
        boats.forEach(boat -> addresses.add("127.0.0.1:" + boat.address().getPort()));
        return List.of(
                "run",
                "clv",
                "--connect",
                String.join(",", addresses),
                "--area",
                "24",
                "--locations",
                "4",
                "--answer-after",
                "0.2",
                "--for",
                "150",
                "--journal",
                journal.toString(),
                "--json");
    }

    private static void zero(Path journal, int page) throws Exception {
        try (RandomAccessFile file = new RandomAccessFile(journal.toFile(), "rw")) {
            file.seek((long) (page - 1) * PAGE);
            file.write(new byte[PAGE]);
        }
    }

    private static void empty(Path journal) throws Exception {
        try (Connection connection = DriverManager.getConnection("jdbc:sqlite:" + journal);
                Statement statement = connection.createStatement()) {
            statement.execute("DELETE FROM telemetry");
        }
    }

    /** The leaves of the telemetry table, in order. */
    private static List<Integer> pages(Path journal) throws Exception {
        List<Integer> found = new ArrayList<>();
        try (Connection connection = DriverManager.getConnection("jdbc:sqlite:" + journal);
                Statement statement = connection.createStatement();
                ResultSet rows = statement.executeQuery(
                        "SELECT pageno FROM dbstat WHERE name = 'telemetry' AND pagetype = 'leaf' ORDER BY path")) {
            while (rows.next()) {
                found.add(rows.getInt(1));
            }
        }
        return found;
    }
}
