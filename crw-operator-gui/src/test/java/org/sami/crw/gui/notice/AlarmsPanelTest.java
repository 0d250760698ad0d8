package org.sami.crw.gui.notice;

import static org.assertj.core.api.Assertions.assertThat;
import static org.sami.crw.gui.SessionWorld.laidOut;
import static org.sami.crw.gui.SessionWorld.rows;
import static org.sami.crw.gui.SessionWorld.select;
import static org.sami.crw.gui.SessionWorld.until;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.sami.crw.gui.SessionWorld;
import org.sami.crw.operator.alarm.Alarm;
import org.sami.crw.operator.alarm.Alarm.Kind;
import org.sami.crw.service.Geodesy;

@Timeout(900)
class AlarmsPanelTest {
    @Test
    void ofABoatThatComesNearToTwoOthersOneAlarmIsAcknowledgedAndTheOtherStays() throws Exception {
        try (SessionWorld world = new SessionWorld(SessionWorld.library("clv"), "anna")) {
            world.add("bert", Geodesy.offset(SessionWorld.PIER, 1, 8));
            world.add("cleo", Geodesy.offset(SessionWorld.PIER, -1, 8));
            AlarmsPanel panel = laidOut(() -> new AlarmsPanel(world.context, (boats, text) -> {}));
            until("anna is about to meet both", () -> {
                world.session.fleet().teleoperate("anna", 1, 0); // who drives by hand does not give way
                return approaches(world).size() == 2;
            });
            until("she lies still", () -> approaches(world).stream().noneMatch(Alarm::active));
            assertThat(rows(panel, "alarms-table")).contains("anna and bert", "anna and cleo");

            select(panel, "alarms-table", 0);
            world.run("alarm-acknowledge");
            until("an alarm is gone", () -> approaches(world).size() < 2);

            assertThat(approaches(world)).hasSize(1);
        }
    }

    private static List<Alarm> approaches(SessionWorld world) {
        return world.context.models().alarms().snapshot().stream()
                .filter(alarm -> alarm.kind() == Kind.APPROACH)
                .toList();
    }
}
