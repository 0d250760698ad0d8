package org.sami.crw.sim.tcp;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.link.SteadyClock;
import org.sami.boat.server.tcp.TcpServerListener;
import org.sami.crw.cli.CommandResult;
import org.sami.crw.report.file.ReportJson;
import org.sami.crw.sim.boat.BoatOnTcp;
import org.sami.crw.sim.boat.BoatSettings;
import org.sami.spn.journal.JournalAddress;
import org.sami.spn.value.GeoPoint;

/** The report of a run that whoever has only its journal makes. */
@Tag("long")
@Timeout(900)
class JournalReportTest {
    private static final ObjectMapper JSON = new ObjectMapper();

    /** What the journal does not hold, or what is of the process that reports. */
    private static final Set<String> NOT_IN_THE_JOURNAL =
            Set.of("startedAt", "timeZone", "version", "wallSeconds", "resumedFrom");

    @TempDir
    private Path folder;

    @Test
    void journalOfARunThatIsOverIsReportedAsTheRunItselfWas() throws Exception {
        Path journal = folder.resolve("run.journal");
        JsonNode own;
        try (BoatOnTcp anna = boat("anna", 10.9);
                BoatOnTcp bert = boat("bert", 10.9001)) {
            CommandResult ran = CommandResult.crw(
                    "run",
                    "clv-interrupts",
                    "--connect",
                    address(anna) + "," + address(bert),
                    "--area",
                    "12",
                    "--locations",
                    "2",
                    "--answer-after",
                    "0.2",
                    "--interrupt",
                    "alarm@2",
                    "--for",
                    "100",
                    "--journal",
                    journal.toString(),
                    "--json");
            own = JSON.readTree(ran.out());
        }

        JsonNode told = JSON.readTree(ReportJson.text(JournalReport.of(JournalAddress.of(journal))));

        assertThat(own.path("interrupts")).isNotEmpty();
        assertThat(own.path("outcome").asText()).isEqualTo("ended");
        List<String> others = new ArrayList<>();
        own.fieldNames().forEachRemaining(member -> {
            if (!NOT_IN_THE_JOURNAL.contains(member)
                    && !member.equals("closestApproach")
                    && !told.path(member).equals(own.path(member))) {
                others.add(member + ": " + told.path(member) + " for " + own.path(member));
            }
        });
        assertThat(others).isEmpty();
        JsonNode approach = told.path("closestApproach");
        assertThat(approach.path("boats")).isEqualTo(own.path("closestApproach").path("boats"));
        assertThat(approach.path("distanceM").asDouble())
                .as("a journal's positions are rounded to a centimetre")
                .isCloseTo(own.path("closestApproach").path("distanceM").asDouble(), within(0.03));
    }

    private static String address(BoatOnTcp boat) {
        return "127.0.0.1:" + boat.address().getPort();
    }

    private BoatOnTcp boat(String name, double lonDeg) throws Exception {
        InetSocketAddress anyPort = new InetSocketAddress(InetAddress.getLoopbackAddress(), 0);
        BoatSettings settings =
                BoatSettings.of(name, anyPort, GeoPoint.of(45.4, lonDeg), 1).loggingTo(folder);
        return new BoatOnTcp(settings, SteadyClock.ofThisMachine(), TcpServerListener.NONE);
    }
}
