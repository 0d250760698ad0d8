package org.sami.crw.sim.boat;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.sami.boat.link.Ack;
import org.sami.boat.link.BoatMode;
import org.sami.boat.link.HeldWaypoints;
import org.sami.boat.link.Hello;
import org.sami.boat.link.LinkMessage;
import org.sami.boat.link.ReadBack;
import org.sami.boat.link.StartWaypoints;
import org.sami.boat.link.StopMotors;
import org.sami.boat.link.UploadWaypoints;
import org.sami.boat.link.Welcome;
import org.sami.boat.server.log.LoggedCommand;
import org.sami.boat.server.testing.Await;
import org.sami.crw.proxy.command.Upload;
import org.sami.crw.sim.boat.TcpTestFleet.Base;
import org.sami.crw.sim.boat.TestRelay.Cut;
import org.sami.crw.sim.boat.TestRelay.Where;

/** Links that are cut before, in and after each message of connecting, uploading, starting and cancelling. */
@Execution(ExecutionMode.CONCURRENT)
@Timeout(900)
class CutLinkTest {
    @TempDir
    private Path logs;

    /** How boats and bases are linked. */
    TestLinks links() {
        return TestLinks.plain();
    }

    static Stream<Arguments> cuts() {
        List<Class<? extends LinkMessage>> messages = List.of(
                Hello.class,
                Welcome.class,
                UploadWaypoints.class,
                ReadBack.class,
                HeldWaypoints.class,
                StartWaypoints.class,
                Ack.class,
                StopMotors.class);
        return messages.stream()
                .flatMap(message -> Stream.of(Where.values()).map(where -> Arguments.of(message, where)));
    }

    @ParameterizedTest
    @MethodSource("cuts")
    void boatHoldsTheWholeOldOrTheWholeNewListAndTheBaseSaysWhich(Class<? extends LinkMessage> message, Where where)
            throws Exception {
        try (TcpTestFleet fleet = new TcpTestFleet(logs, links())) {
            BoatOnTcp boat = fleet.boat("anna");
            TestRelay relay = fleet.relay(boat);
            Base base = fleet.base("base");
            base.connect(relay.address(), "anna");
            base.submit("anna", TcpTestFleet.path("old", 1));
            base.awaitMode("anna", BoatMode.PATH);
            String oldList = base.upload("anna").orElseThrow().listId();

            relay.arm(new Cut(message, where));
            if (message == Hello.class || message == Welcome.class) {
                relay.cut(); // it is cut again while it comes back
            }
            base.submit("anna", TcpTestFleet.path("new", 1, 1000));
            if (message != StopMotors.class) {
                Await.until("the cut", () -> !relay.isArmed());
                Await.until(
                        "the base says which",
                        () -> base.ask(
                                "anna",
                                proxy -> proxy.commands()
                                        .heldListId()
                                        .orElseThrow()
                                        .equals(lastUploaded(fleet, oldList))));
            }
            Await.until("the new list is started", () -> isStarted(base, fleet));
            assertThat(base.heldListId("anna")).contains(lastUploaded(fleet, oldList));

            base.ask("anna", proxy -> proxy.commands().withdraw(1));
            Await.until("it is cancelled", () -> isCancelled(base, fleet, message == StopMotors.class));

            assertThat(relay.isArmed()).isFalse();
            assertThat(fleet.executedIds("anna")).doesNotHaveDuplicates();
            assertThat(base.failures).isEmpty();
        }
    }

    /** It has stopped; cut after the answer to that, it does what is set for a lost link, and nobody wants it otherwise. */
    private static boolean isCancelled(Base base, TcpTestFleet fleet, boolean cutSince) {
        Optional<BoatMode> mode = base.mode("anna");
        boolean rests = mode.equals(Optional.of(BoatMode.STOPPED));
        boolean holds = cutSince && mode.equals(Optional.of(BoatMode.HOLD));
        return fleet.executedOf("anna", "stop") > 0 && (rests || holds);
    }

    private static boolean isStarted(Base base, TcpTestFleet fleet) {
        Optional<Upload> upload = base.upload("anna");
        return upload.isPresent()
                && upload.get().listId().startsWith("new#")
                && upload.get().state() == Upload.State.READ_BACK_EQUAL
                && entries(fleet).stream()
                        .anyMatch(entry -> entry.command() instanceof StartWaypoints start
                                && start.listId().equals(upload.get().listId()));
    }

    /** The list that the boat took last, by its own log. */
    private static String lastUploaded(TcpTestFleet fleet, String before) {
        return entries(fleet).stream()
                .filter(entry -> entry.command() instanceof UploadWaypoints)
                .map(entry -> ((UploadWaypoints) entry.command()).listId())
                .reduce(before, (earlier, later) -> later);
    }

    private static List<LoggedCommand> entries(TcpTestFleet fleet) {
        try {
            return fleet.log("anna");
        } catch (java.io.IOException e) {
            throw new java.io.UncheckedIOException(e);
        }
    }
}
