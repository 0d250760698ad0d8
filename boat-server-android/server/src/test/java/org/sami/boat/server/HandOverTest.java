package org.sami.boat.server;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.sami.boat.link.Ack;
import org.sami.boat.link.AskForCommand;
import org.sami.boat.link.BoatMode;
import org.sami.boat.link.CommandAsked;
import org.sami.boat.link.CommandMessage;
import org.sami.boat.link.GrantCommand;
import org.sami.boat.link.Hello;
import org.sami.boat.link.HoldPosition;
import org.sami.boat.link.LinkMessage;
import org.sami.boat.link.Nack;
import org.sami.boat.link.NackReason;
import org.sami.boat.link.Role;
import org.sami.boat.link.StartWaypoints;
import org.sami.boat.link.TakeCommand;
import org.sami.boat.link.UploadWaypoints;
import org.sami.boat.link.Waypoint;
import org.sami.boat.link.Welcome;
import org.sami.boat.server.ServerTestBench.Client;

/** The command of a boat changes hands only by a message that says so. */
class HandOverTest {
    private final ServerTestBench bench = new ServerTestBench();

    private Client greet(String clientId, Role role) {
        Client client = bench.new Client();
        client.say(new Hello("", clientId, role, 1, ""));
        return client;
    }

    private static Role role(Client client) {
        List<Welcome> welcomes = client.all(Welcome.class);
        return welcomes.get(welcomes.size() - 1).role();
    }

    /** The answer to a command that the client gets, whatever else comes with it. */
    private static LinkMessage answer(Client client, CommandMessage command) {
        List<LinkMessage> got = client.say(command);
        return got.get(got.size() - 1);
    }

    private static void assertNack(LinkMessage answer, NackReason reason) {
        assertThat(answer).isInstanceOf(Nack.class);
        assertThat(((Nack) answer).reason()).isEqualTo(reason);
    }

    @Test
    void helloToWhicheverBoatLearnsItsName() {
        Client client = greet("a", Role.OBSERVER);

        assertThat(client.all(Welcome.class))
                .singleElement()
                .extracting(Welcome::boatId)
                .isEqualTo("boat1");
    }

    @Test
    void wishIsPassedOnAndGrantedByTheCommander() {
        Client first = greet("a", Role.COMMANDER);
        Client second = greet("b", Role.OBSERVER);

        assertThat(answer(second, new AskForCommand("ask"))).isInstanceOf(Ack.class);
        assertThat(first.all(CommandAsked.class))
                .singleElement()
                .extracting(CommandAsked::clientId)
                .isEqualTo("b");
        assertThat(role(second)).isEqualTo(Role.OBSERVER);

        assertThat(answer(first, new GrantCommand("grant", "b"))).isInstanceOf(Ack.class);
        assertThat(role(first)).isEqualTo(Role.OBSERVER);
        assertThat(role(second)).isEqualTo(Role.COMMANDER);
        assertNack(first.command(new HoldPosition("h1")), NackReason.NOT_COMMANDER);
        assertThat(second.command(new HoldPosition("h2"))).isInstanceOf(Ack.class);
    }

    @Test
    void wishIsGrantedAtOnceWhereNobodyCommands() {
        Client client = greet("a", Role.OBSERVER);

        assertThat(answer(client, new AskForCommand("ask"))).isInstanceOf(Ack.class);

        assertThat(role(client)).isEqualTo(Role.COMMANDER);
    }

    @Test
    void takingOverNeedsNoConsentAndLeavesTheBoatOnItsWay() {
        Client first = greet("a", Role.COMMANDER);
        first.command(new UploadWaypoints("u", "l", List.of(new Waypoint(45.01, 10, 1))));
        first.command(new StartWaypoints("s", "l", 0));
        Client second = greet("b", Role.OBSERVER);

        assertThat(answer(second, new TakeCommand("take"))).isInstanceOf(Ack.class);
        bench.run(1, first, second);

        assertThat(role(first)).isEqualTo(Role.OBSERVER);
        assertThat(role(second)).isEqualTo(Role.COMMANDER);
        assertThat(bench.server.mode()).isEqualTo(BoatMode.PATH);
    }

    @Test
    void boatFollowsTheLinkOfWhoCommandsNow() {
        Client first = greet("a", Role.COMMANDER);
        Client second = greet("b", Role.OBSERVER);
        second.say(new TakeCommand("take"));

        bench.run(4, first);
        assertThat(bench.server.hasCommander()).isFalse();
        second.say(new Hello("", "b", Role.COMMANDER, 1, ""));
        first.session.closed(bench.nowMs);
        assertThat(bench.server.hasCommander()).isTrue();
    }

    @Test
    void repeatedTakeOverIsAnsweredAndDoesNotTakeOverAgain() {
        Client first = greet("a", Role.COMMANDER);
        Client second = greet("b", Role.OBSERVER);
        second.say(new TakeCommand("take"));
        first.say(new TakeCommand("take back"));

        assertThat(answer(second, new TakeCommand("take"))).isInstanceOf(Ack.class);

        assertThat(role(second)).isEqualTo(Role.OBSERVER);
        assertThat(first.command(new HoldPosition("h"))).isInstanceOf(Ack.class);
    }

    @Test
    void observerThatAsksInMassesIsRefusedAndNeitherFillsTheCommandersLinkNorTheLog() {
        Client first = greet("a", Role.COMMANDER);
        Client second = greet("b", Role.OBSERVER);
        int refused = 0;
        for (int i = 0; i < 1000; i++) {
            refused += answer(second, new AskForCommand("ask" + i)) instanceof Nack ? 1 : 0;
            answer(second, new GrantCommand("grant" + i, "b"));
        }

        assertThat(first.all(CommandAsked.class)).hasSize(3);
        assertThat(refused).isEqualTo(997);
        assertNack(answer(second, new AskForCommand("once more")), NackReason.TOO_OFTEN);
        assertThat(bench.log).isEmpty();
        bench.run(6, first, second);
        assertThat(answer(second, new AskForCommand("later"))).isInstanceOf(Ack.class);
    }

    @Test
    void observersThatComeAnewForEachWishAreLimitedTogether() {
        Client first = greet("a", Role.COMMANDER);
        for (int i = 0; i < 200; i++) {
            Client next = greet("b" + i, Role.OBSERVER);
            next.say(new AskForCommand("ask" + i));
            next.session.closed(bench.nowMs);
        }

        assertThat(first.all(CommandAsked.class)).hasSize(20);
    }

    @Test
    void clientsThatTakeTheCommandInTurnsAlwaysGetItAndDoNotFillTheLog() {
        Client first = greet("a", Role.COMMANDER);
        Client second = greet("b", Role.OBSERVER);
        for (int i = 0; i < 1000; i++) {
            assertThat(answer(second, new TakeCommand("take" + i))).isInstanceOf(Ack.class);
            assertThat(answer(first, new TakeCommand("back" + i))).isInstanceOf(Ack.class);
        }

        assertThat(bench.log).hasSize(100);
        bench.run(60, first, second);
        second.say(new TakeCommand("later"));
        assertThat(bench.log).endsWith("left out: 1900", "later ack");
    }

    @Test
    void observerGrantsNothingAndNobodyGrantsToAStranger() {
        Client first = greet("a", Role.COMMANDER);
        Client second = greet("b", Role.OBSERVER);

        assertNack(answer(second, new GrantCommand("g1", "b")), NackReason.NOT_COMMANDER);
        assertNack(answer(first, new GrantCommand("g2", "c")), NackReason.UNKNOWN_CLIENT);
        assertNack(answer(bench.new Client(), new TakeCommand("t")), NackReason.NOT_GREETED);
        assertThat(role(first)).isEqualTo(Role.COMMANDER);
    }
}
