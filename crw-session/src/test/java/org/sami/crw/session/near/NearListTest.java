package org.sami.crw.session.near;

import static org.assertj.core.api.Assertions.assertThat;

import java.net.InetSocketAddress;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import org.junit.jupiter.api.Test;
import org.sami.boat.link.BoatAnnouncement;
import org.sami.boat.link.BoatAnnouncement.Access;
import org.sami.crw.proxy.near.FoundBoat;
import org.sami.crw.proxy.near.NearBoat;
import org.sami.crw.proxy.near.NearBoat.State;
import org.sami.crw.proxy.tcp.BoatAddress;
import org.sami.crw.proxy.tcp.LinkReport;

/** What is announced and what is linked, in one list, and what one press does with it. */
class NearListTest {
    @Test
    void announcedAndLinkedBoatsAreListedOnceByTheirNames() {
        NearList list = NearList.of(
                List.of(near("boat10", 10, State.PAIRED), near("boat9", 9, State.NOT_PAIRED)),
                List.of(link(10, "boat10", true, 0, ""), link(8, "boat8", true, 0, "")),
                List.of());

        assertThat(list.rows()).extracting(NearRow::name).containsExactly("boat8", "boat9", "boat10");
        assertThat(list.rows()).extracting(NearRow::words).containsExactly("connected", "not paired", "connected");
    }

    @Test
    void onePressConnectsWhatIsPairedOrOpenAndSaysWhyTheRestIsLeft() {
        NearList list = NearList.of(
                List.of(
                        near("anna", 1, State.PAIRED),
                        near("bert", 2, State.OPEN),
                        near("carl", 3, State.PAIRING),
                        near("dora", 4, State.NOT_PAIRED),
                        near("emil", 5, State.PLAIN_REFUSED),
                        near("fina", 6, State.PAIRED)),
                List.of(link(6, "fina", true, 0, ""), link(7, null, false, 3, "connection refused")),
                List.of());

        ConnectAll all = ConnectAll.of(list);

        assertThat(all.connects()).containsExactly(at(1), at(2));
        assertThat(all.left())
                .containsExactly(
                        "10.0.0.1:7: does not answer, connection refused; it goes on being tried",
                        "carl: waits to be paired, select it and press Pair",
                        "dora: not paired, have it show its words, then press Pair",
                        "emil: plain, needs --open, pair it, or start this program with --open if whoever reaches it"
                                + " may command it");
        assertThat(all.words(list))
                .isEqualTo("0 of 2 connected. Not connected: 10.0.0.1:7 (does not answer); carl (waits to be paired);"
                        + " dora (not paired); emil (plain, needs --open)");
    }

    @Test
    void wordsFollowWhatBecomesOfTheAddresses() {
        ConnectAll all = ConnectAll.of(NearList.of(List.of(near("anna", 1, State.PAIRED)), List.of(), List.of()));

        NearList later =
                NearList.of(List.of(near("anna", 1, State.PAIRED)), List.of(link(1, "anna", true, 0, "")), List.of());

        assertThat(all.words(later)).isEqualTo("1 of 1 connected");
        assertThat(ConnectAll.of(later).words(later)).isEqualTo("No further boat can be connected now");
    }

    @Test
    void boatThatIsLinkedAtAnotherAddressIsNotConnectedTwice() {
        NearList list = NearList.of(
                List.of(near("anna", 1, State.OPEN), near("bert", 3, State.OPEN), near("bert", 4, State.OPEN)),
                List.of(link(2, "anna", true, 0, "")),
                List.of());

        ConnectAll all = ConnectAll.of(list);

        assertThat(all.connects()).containsExactly(at(3));
        assertThat(all.left())
                .containsExactly(
                        "anna: connected at 10.0.0.1:2",
                        "bert at 10.0.0.1:4: a boat of that id is connected at 10.0.0.1:3");
    }

    @Test
    void lostLinkIsNoConnection() {
        NearList list = NearList.of(
                List.of(near("anna", 1, State.PAIRED)),
                List.of(link(1, "anna", false, 2, "nothing has come for 3500 ms")),
                List.of());
        NearRow lost = list.rows().get(0);

        assertThat(lost.state()).isEqualTo(NearRow.Link.FAILING);
        assertThat(lost.words()).isEqualTo("link lost");
        assertThat(lost.advice()).isEqualTo("nothing has come for 3500 ms; it goes on being tried");
        assertThat(ConnectAll.of(list).words(list)).endsWith("Not connected: anna (link lost)");
    }

    private static NearBoat near(String name, int port, State state) {
        return new NearBoat(
                new FoundBoat(
                        new BoatAnnouncement(name, name, "", Access.OPEN, 2, OptionalInt.of(50), "rudder"), at(port)),
                state);
    }

    private static BoatAddress at(int port) {
        return new BoatAddress("10.0.0.1", port);
    }

    private static LinkReport link(int port, String boat, boolean connected, long failed, String event) {
        return new LinkReport(
                InetSocketAddress.createUnresolved("10.0.0.1", port),
                Optional.ofNullable(boat),
                connected,
                1,
                event,
                false,
                failed,
                failed,
                List.of());
    }
}
