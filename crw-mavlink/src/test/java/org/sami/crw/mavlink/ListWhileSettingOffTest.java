package org.sami.crw.mavlink;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.link.Ack;
import org.sami.boat.link.HeldWaypoints;
import org.sami.boat.link.HoldPosition;
import org.sami.boat.link.Progress;
import org.sami.boat.link.ReadBack;
import org.sami.boat.link.StartWaypoints;
import org.sami.boat.link.UploadWaypoints;
import org.sami.boat.link.Waypoint;
import org.sami.boat.server.testing.Await;
import org.sami.mavlink.testing.SmallBoat;

/** A list that comes while the vehicle sets off along another one, and may drive before its heartbeat says so. */
@Timeout(900)
class ListWhileSettingOffTest {
    private static final int LOITER = 5;
    private static final int AUTO = 10;
    private static final int SET_MODE = 176;
    private static final List<Waypoint> LIST = List.of(new Waypoint(45.71, 10.72, 1), new Waypoint(45.71, 10.73, 1));

    @TempDir
    private Path folder;

    private SmallBoat boat;
    private LinkClient client;

    @BeforeEach
    void launch() throws Exception {
        boat = new SmallBoat(5, 45.7, 10.72, 1);
        client = new LinkClient(folder, boat.address() + "/5");
    }

    @AfterEach
    void end() throws Exception {
        client.close();
        boat.close();
    }

    private static UploadWaypoints upload(String list) {
        return new UploadWaypoints("upload " + list, list, LIST);
    }

    /** The vehicle does not say in which mode it is, and the gateway does not give that up meanwhile. */
    private void keepHeartbeats() {
        client.slow(true);
        boat.reports().beating(false);
    }

    private void sendHeartbeats() {
        boat.reports().beating(true);
        client.slow(false);
    }

    @Test
    void listThatComesWhileItSetsOffIsSentWhileItKeepsItsPlace() {
        assertThat(client.ask(upload("first"))).isInstanceOf(Ack.class);
        assertThat(client.ask(new HoldPosition("hold"))).isInstanceOf(Ack.class);
        keepHeartbeats();
        client.say(new StartWaypoints("start", "first", 0));
        Await.until("it sets off", () -> boat.mode() == AUTO);

        UploadWaypoints second = upload("second");
        client.say(second);
        Await.until("it is ordered", () -> modes().size() == 3);
        sendHeartbeats();

        assertThat(client.answerTo(second)).isInstanceOf(Ack.class);
        assertThat(client.ask(new StartWaypoints("start second", "second", 0))).isInstanceOf(Ack.class);
        assertThat(modes()).containsExactly(LOITER, AUTO, LOITER, AUTO);
    }

    /** The modes into which it was ordered, without those that it was ordered into again: an order whose answer may be that to the one before is sent twice. */
    private List<Integer> modes() {
        List<Integer> all = boat.orderedModes();
        return IntStream.range(0, all.size())
                .filter(i -> i == 0 || !all.get(i).equals(all.get(i - 1)))
                .mapToObj(all::get)
                .toList();
    }

    /** The answer to an order cannot be told from that to the one before it, so the order is sent again. */
    @Test
    void listThatComesBeforeTheOrderToSetOffIsAnsweredIsSentWhileItKeepsItsPlace() {
        assertThat(client.ask(upload("first"))).isInstanceOf(Ack.class);
        assertThat(client.ask(new HoldPosition("hold"))).isInstanceOf(Ack.class);
        assertThat(client.ask(new ReadBack("read"))).isInstanceOf(HeldWaypoints.class);
        keepHeartbeats();
        boat.keepAnswers(true, SET_MODE);
        client.say(new StartWaypoints("start", "first", 0));
        Await.until("it sets off", () -> boat.mode() == AUTO);

        UploadWaypoints second = upload("second");
        client.say(second);
        Await.until("it is ordered", () -> boat.mode() == LOITER);
        boat.keepAnswers(false, SET_MODE);
        Await.until("it is ordered again", () -> boat.orderedModes().size() == 4);
        sendHeartbeats();

        assertThat(client.answerTo(second)).isInstanceOf(Ack.class);
        assertThat(client.ask(new StartWaypoints("start second", "second", 0))).isInstanceOf(Ack.class);
        assertThat(boat.orderedModes()).containsExactly(LOITER, AUTO, LOITER, LOITER, AUTO);
    }

    @Test
    void waypointThatIsReachedBeforeAHeartbeatTellsTheModeIsReached() {
        List<Waypoint> near = List.of(new Waypoint(45.70002, 10.72, 1), new Waypoint(45.71, 10.72, 1));
        assertThat(client.ask(new UploadWaypoints("upload", "near", near))).isInstanceOf(Ack.class);
        assertThat(client.ask(new HoldPosition("hold"))).isInstanceOf(Ack.class);
        assertThat(client.ask(new ReadBack("read"))).isInstanceOf(HeldWaypoints.class);
        keepHeartbeats();
        StartWaypoints start = new StartWaypoints("start", "near", 0);
        client.say(start);
        Await.until("the first is reached", () -> boat.mission().visited().size() == 1);
        sendHeartbeats();

        assertThat(client.answerTo(start)).isInstanceOf(Ack.class);
        Await.until(
                "it is reported",
                20,
                () -> client.last(Progress.class)
                        .filter(progress -> progress.nextIndex() == 1)
                        .isPresent());
    }
}
