package org.sami.crw.sim.boat;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.sami.boat.link.BoatMode;
import org.sami.crw.cli.CommandResult;
import org.sami.crw.proxy.BoatProxy;
import org.sami.crw.sim.boat.TcpTestFleet.Base;

/** {@code crw stop} against real boats on loopback. */
@Execution(ExecutionMode.CONCURRENT)
@Timeout(900)
class StopCommandTest {
    @TempDir
    private Path logs;

    /** Ends as soon as all boats have answered, which takes its time on a busy machine. */
    private static CommandResult stop(String... arguments) {
        return CommandResult.crw(Stream.concat(Stream.of("stop", "--within", "60"), Stream.of(arguments))
                .toArray(String[]::new));
    }

    @Test
    void everyBoatIsStoppedAndSaysSo() throws Exception {
        try (TcpTestFleet fleet = new TcpTestFleet(logs)) {
            BoatOnTcp anna = fleet.boat("anna");
            BoatOnTcp bert = fleet.boat("bert");

            CommandResult ran = stop(at(anna), at(bert));

            assertThat(ran.exitCode()).as(ran.out() + ran.err()).isZero();
            assertThat(ran.out().lines())
                    .containsExactly(
                            at(anna) + "  anna: stopped, and the stop is latched",
                            at(bert) + "  bert: stopped, and the stop is latched");
            assertThat(fleet.executed("anna", "fleet-stop")).isEqualTo(1);
            assertThat(fleet.executed("bert", "fleet-stop")).isEqualTo(1);
        }
    }

    @Test
    void boatThatAnotherBaseDrivesIsStopped() throws Exception {
        try (TcpTestFleet fleet = new TcpTestFleet(logs)) {
            BoatOnTcp anna = fleet.boat("anna");
            Base base = fleet.base("base");
            base.connect(anna.address(), "anna");
            base.submit("anna", TcpTestFleet.path("far", 1, 1000));
            base.awaitMode("anna", BoatMode.PATH);

            CommandResult ran = stop(at(anna));

            assertThat(ran.exitCode()).as(ran.out() + ran.err()).isZero();
            assertThat(ran.out()).contains("anna: stopped").doesNotContain("taken over");
            assertThat(base.ask("anna", BoatProxy::isCommanding)).isTrue();
            base.awaitMode("anna", BoatMode.FLEET_STOP);
        }
    }

    @Test
    void addressWithoutABoatIsNamedAndTheOthersAreStopped() throws Exception {
        try (TcpTestFleet fleet = new TcpTestFleet(logs)) {
            BoatOnTcp anna = fleet.boat("anna");
            BoatOnTcp gone = fleet.boat("gone");
            String nowhere = at(gone);
            gone.close();

            CommandResult ran = CommandResult.crw("stop", nowhere + "," + at(anna), "--within", "15");

            assertThat(ran.exitCode()).isEqualTo(4);
            assertThat(ran.out()).contains(nowhere + "  no answer", "anna: stopped");
        }
    }

    @Test
    void releaseTakesTwoSteps() throws Exception {
        try (TcpTestFleet fleet = new TcpTestFleet(logs)) {
            BoatOnTcp anna = fleet.boat("anna");
            stop(at(anna));

            CommandResult first = stop("--release", at(anna));

            assertThat(first.exitCode()).isEqualTo(2);
            assertThat(first.out()).contains("anna: stopped, and the stop is latched");
            assertThat(first.err()).contains("nothing was released; 1 boat is stopped", "--confirm");
            assertThat(fleet.executed("anna", "fleet-release")).isZero();

            CommandResult second = stop("--release", "--confirm", at(anna));

            assertThat(second.exitCode()).as(second.out() + second.err()).isZero();
            assertThat(second.out()).contains("anna: released");
            assertThat(fleet.executed("anna", "fleet-release")).isEqualTo(1);
        }
    }

    private static String at(BoatOnTcp boat) {
        return "127.0.0.1:" + boat.address().getPort();
    }
}
