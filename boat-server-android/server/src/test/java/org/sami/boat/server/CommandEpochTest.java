package org.sami.boat.server;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.sami.boat.link.Ack;
import org.sami.boat.link.AskForCommand;
import org.sami.boat.link.BoatMode;
import org.sami.boat.link.CommandEpoch;
import org.sami.boat.link.CommandMessage;
import org.sami.boat.link.FleetStop;
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

/** A base that was replaced does not get the command again by asking for it: the number of its appointment is too low. */
class CommandEpochTest {
    private ServerTestBench bench = new ServerTestBench();

    private Client link() {
        return bench.new Client();
    }

    private static Hello hello(String base, Role role, long epoch) {
        return new Hello("boat1", base, role, 1, "", base + ".0", epoch);
    }

    private Client commander(String base, long epoch) {
        Client client = link();
        client.say(hello(base, Role.COMMANDER, epoch));
        return client;
    }

    private static Welcome welcome(Client client) {
        List<Welcome> all = client.all(Welcome.class);
        return all.get(all.size() - 1);
    }

    private static LinkMessage answer(Client client, CommandMessage command) {
        List<LinkMessage> got = client.say(command);
        return got.get(got.size() - 1);
    }

    private static void assertSuperseded(LinkMessage answer, String holder) {
        assertThat(answer).isInstanceOf(Nack.class);
        assertThat(((Nack) answer).reason()).isEqualTo(NackReason.SUPERSEDED);
        assertThat(((Nack) answer).detail()).contains(holder + " has the command, number 2");
    }

    private static Nack last(Client client) {
        List<Nack> all = client.all(Nack.class);
        return all.get(all.size() - 1);
    }

    /** Base a commands, is cut off, and base b takes the boat over and goes. */
    private Client replaced() {
        Client first = commander("a", 1);
        Client second = link();
        second.say(hello("b", Role.OBSERVER, 2));
        assertThat(answer(second, new TakeCommand("take", "b.0", 2))).isInstanceOf(Ack.class);
        second.session.closed(bench.nowMs);
        return first;
    }

    @Test
    void baseThatWasReplacedAndAsksAgainIsRefusedAndTheBoatStaysWhereItIs() {
        Client first = replaced();

        assertSuperseded(answer(first, new AskForCommand("ask", "a.0", 1)), "b");
        assertSuperseded(answer(first, new TakeCommand("take again", "a.0", 1)), "b");
        first.say(hello("a", Role.COMMANDER, 1));
        assertSuperseded(last(first), "b");
        assertThat(welcome(first).role()).isEqualTo(Role.OBSERVER);

        first.say(new UploadWaypoints("u", "l", List.of(new Waypoint(45.01, 10, 1))));
        first.say(new StartWaypoints("s", "l", 0));
        assertThat(bench.server.mode()).isEqualTo(BoatMode.STOPPED);
    }

    @Test
    void baseThatComesBackOverAnotherLinkAfterItWasReplacedIsRefused() {
        replaced().session.closed(bench.nowMs);

        Client again = commander("a", 1);

        assertSuperseded(last(again), "b");
        assertThat(welcome(again).epoch().map(CommandEpoch::number)).isEqualTo(Optional.of(2L));
        assertThat(bench.server.hasCommander()).isFalse();
    }

    @Test
    void replacedBaseTakesOverWithAHigherNumberThatItLearnsFromTheWelcome() {
        Client first = replaced();
        long newest = welcome(first).epoch().orElseThrow().number();

        assertThat(answer(first, new TakeCommand("take back", "a.0", newest + 1)))
                .isInstanceOf(Ack.class);

        assertThat(welcome(first).role()).isEqualTo(Role.COMMANDER);
        assertThat(welcome(first).epoch().orElseThrow().clientId()).isEqualTo("a");
        assertThat(first.command(new HoldPosition("h"))).isInstanceOf(Ack.class);
    }

    @Test
    void sameBaseGoesOnAfterALostLinkWithItsNumber() {
        commander("a", 1).session.closed(bench.nowMs);

        assertThat(welcome(commander("a", 1)).role()).isEqualTo(Role.COMMANDER);
    }

    @Test
    void twoBasesWithOneNumberDoNotShareIt() {
        commander("a", 1).session.closed(bench.nowMs);

        Client other = commander("b", 1);

        assertThat(welcome(other).role()).isEqualTo(Role.OBSERVER);
        assertThat(last(other).reason()).isEqualTo(NackReason.SUPERSEDED);
        assertThat(welcome(commander("c", 2)).role()).isEqualTo(Role.COMMANDER);
    }

    @Test
    void numberOfAGrantIsTheNextOne() {
        Client first = commander("a", 7);
        Client second = link();
        second.say(hello("b", Role.OBSERVER, 8));

        assertThat(answer(first, new GrantCommand("g", "b"))).isInstanceOf(Ack.class);

        assertThat(welcome(second).epoch().orElseThrow().number()).isEqualTo(8);
        second.session.closed(bench.nowMs);
        assertThat(welcome(commander("b", 8)).role()).isEqualTo(Role.COMMANDER);
    }

    @Test
    void numberThatWouldKeepOutAllOthersIsRefused() {
        Client greedy = commander("a", Long.MAX_VALUE);

        assertThat(welcome(greedy).role()).isEqualTo(Role.OBSERVER);
        assertThat(welcome(commander("b", 1)).role()).isEqualTo(Role.COMMANDER);
    }

    @Test
    void restartedBoatKeepsItsNumber() {
        replaced();

        bench = bench.startedAnew();

        assertSuperseded(last(commander("a", 1)), "b");
        assertThat(welcome(commander("c", 3)).role()).isEqualTo(Role.COMMANDER);
    }

    @Test
    void whoeverIsLinkedStopsTheBoatAndOnlyTheCommanderReleasesIt() {
        Client first = replaced();
        Client third = commander("c", 3);
        third.say(new HoldPosition("h"));

        assertThat(first.command(new FleetStop("stop"))).isInstanceOf(Ack.class);
        assertThat(bench.server.mode()).isEqualTo(BoatMode.FLEET_STOP);
        int logged = bench.log.size();
        for (int i = 0; i < 1000; i++) {
            assertThat(first.command(new FleetStop("more" + i))).isInstanceOf(Ack.class);
        }

        assertThat(bench.log).hasSize(logged);
        assertThat(welcome(third).role()).isEqualTo(Role.COMMANDER);
    }

    @Test
    void baseOfTheLinkOfBeforeCommandsOnlyABoatThatNoNumberedBaseHasCommandedUnlessAPersonTakesIt() {
        Client before = bench.commander();
        assertThat(welcome(before).role()).isEqualTo(Role.COMMANDER);
        before.session.closed(bench.nowMs);
        commander("a", 1).session.closed(bench.nowMs);

        Client again = bench.commander();

        assertThat(welcome(again).role()).isEqualTo(Role.OBSERVER);
        Nack refused = (Nack) answer(again, new AskForCommand("ask"));
        assertThat(refused.reason()).isEqualTo(NackReason.NOT_COMMANDER);
        assertThat(refused.detail()).contains("the link of before").contains("a has the command, number 1");
        assertThat(answer(again, new TakeCommand("take"))).isInstanceOf(Ack.class);
        again.session.closed(bench.nowMs);
        assertThat(welcome(bench.commander()).role()).isEqualTo(Role.COMMANDER);
        assertThat(last(commander("b", 1)).detail()).contains("test has the command, number 2");
    }
}
