package org.sami.crw.proxy;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.sami.boat.link.HeldWaypoints;
import org.sami.boat.link.Nack;
import org.sami.boat.link.NackReason;
import org.sami.boat.link.ReadBack;
import org.sami.boat.link.UploadWaypoints;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.proxy.command.FollowPath;
import org.sami.crw.proxy.command.Upload;
import org.sami.crw.proxy.command.UploadCount;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.GeoPoint;

/** How far a path has come on its way to the boat, as listeners hear it. */
class UploadTest {
    private static final List<GeoPoint> POINTS = List.of(GeoPoint.of(45, 10), GeoPoint.of(45.01, 10.01));

    private final List<String> heard = new ArrayList<>();
    private final ScriptedBoat boat = new ScriptedBoat(event -> {
        if (event instanceof FleetEvent.UploadAdvanced advanced) {
            Upload upload = advanced.upload();
            heard.add(upload.commandId() + " " + upload.state() + (upload.why().isEmpty() ? "" : ": " + upload.why()));
        }
    });

    @BeforeEach
    void link() {
        boat.linked("b1");
        boat.proxy.commands().submit(FollowPath.of("c", 1, 1, POINTS, Priority.MEDIUM));
    }

    @Test
    void eachStateIsToldOnce() {
        boat.alive(3);
        boat.setsOut();

        assertThat(heard).containsExactly("c SENT", "c ACKNOWLEDGED", "c READ_BACK_EQUAL");
        assertThat(boat.proxy.commands().uploads()).isEqualTo(new UploadCount(1, 1, 1, 0));
        assertThat(boat.proxy.commands().upload().orElseThrow().way()).isEqualTo(POINTS);
    }

    @Test
    void aListThatIsReadBackOtherwiseHasFailedAndIsSentAnew() {
        for (int i = 0; i < 3; i++) {
            boat.acknowledges(UploadWaypoints.class);
            UploadWaypoints sent = boat.last(UploadWaypoints.class);
            boat.says(new HeldWaypoints(
                    boat.last(ReadBack.class).commandId(),
                    sent.listId(),
                    sent.waypoints().subList(0, 1)));
        }

        assertThat(heard)
                .hasSize(9)
                .startsWith("c SENT", "c ACKNOWLEDGED", "c FAILED: the boat does not hold the path that was sent")
                .endsWith("c FAILED: the boat does not hold the path that was sent");
        assertThat(boat.proxy.commands().uploads()).isEqualTo(new UploadCount(3, 3, 0, 3));
    }

    @Test
    void aRefusalIsTheReasonOfTheFailure() {
        boat.says(new Nack(boat.last(UploadWaypoints.class).commandId(), NackReason.TOO_LONG, "at most 1"));

        assertThat(heard).containsExactly("c SENT", "c FAILED: the boat refused it: TOO_LONG, at most 1");
    }

    @Test
    void whatABoatNeverAnswersHasFailed() {
        boat.alive(25);

        assertThat(heard).containsExactly("c SENT", "c FAILED: the boat did not answer 20 requests");
    }

    @Test
    void anUploadThatIsNoLongerWantedHasFailed() {
        boat.proxy.commands().withdraw(1);

        assertThat(heard).containsExactly("c SENT", "c FAILED: its command is no longer wanted");
    }

    @Test
    void anUploadThatTheLinkCutHasFailedAndTheNextIsAnotherOne() {
        boat.silent(5);
        boat.linked("b1");

        assertThat(heard).containsExactly("c SENT", "c FAILED: the boat holds another list", "c SENT");
    }

    @Test
    void aPathThatIsThereIsNoFailureWhenThePersonTakesOver() {
        boat.setsOut();
        boat.proxy.teleoperate(1, 0);

        assertThat(heard).containsExactly("c SENT", "c ACKNOWLEDGED", "c READ_BACK_EQUAL");
    }
}
