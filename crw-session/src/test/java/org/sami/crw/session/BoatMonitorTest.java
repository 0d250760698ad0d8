package org.sami.crw.session;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.sami.crw.proxy.BoatProxy;
import org.sami.crw.proxy.ProxyRegistry;
import org.sami.crw.proxy.command.FollowPath;
import org.sami.crw.proxy.explanation.MissionTitles;
import org.sami.crw.proxy.link.ProxyConfig;
import org.sami.crw.session.archive.SessionJournal;
import org.sami.session.record.FleetHistory;
import org.sami.session.record.SessionTelemetry;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.GeoPoint;

/** What is said of a boat that a mission wants something of and that does not move. */
class BoatMonitorTest {
    private static final String WHY = "anna does not move: the boat has not answered yet; one command waits";

    private final FleetHistory status = new FleetHistory();
    private final SessionTelemetry telemetry = new SessionTelemetry(SessionJournal.none()::addTelemetry, () -> 0);
    private final SessionMessages messages = new SessionMessages(telemetry, message -> {});
    private final List<String> notices = new ArrayList<>();
    private final BoatMonitor watch = new BoatMonitor(status, telemetry, messages, MissionTitles.NONE, true, () -> 0);
    private final BoatProxy anna = new BoatProxy("anna", frame -> {}, event -> {}, ProxyConfig.DEFAULT);
    private final ProxyRegistry boats = new ProxyRegistry();

    BoatMonitorTest() {
        boats.add(anna);
        messages.add(new SessionListener() {
            @Override
            public void onNotice(String text) {
                notices.add(text);
            }
        });
    }

    private void look(int times) {
        for (int i = 0; i < times; i++) {
            watch.look(boats);
        }
    }

    @Test
    void whyABoatStandsStillIsSaidOnceWhenItLasts() {
        anna.commands().submit(FollowPath.of("m1-a1-anna", 1, 1, List.of(GeoPoint.of(45, 10)), Priority.MEDIUM));

        look(2);
        assertThat(notices).isEmpty();
        look(1);
        assertThat(notices).containsExactly(WHY);
        look(5);
        assertThat(notices).hasSize(1);
        assertThat(status.link("anna").why()).isEqualTo(WHY);
    }
}
