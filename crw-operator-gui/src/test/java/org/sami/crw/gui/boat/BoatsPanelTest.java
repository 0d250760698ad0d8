package org.sami.crw.gui.boat;

import static org.assertj.core.api.Assertions.assertThat;
import static org.sami.crw.gui.EventThreadCall.onEventThread;
import static org.sami.crw.gui.SessionWorld.get;
import static org.sami.crw.gui.SessionWorld.laidOut;
import static org.sami.crw.gui.SessionWorld.until;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.sami.crw.gui.SessionWorld;

@Timeout(120)
class BoatsPanelTest {
    @Test
    void aBoatThatIsGoneIsSelectedNoLonger() throws Exception {
        try (SessionWorld world = new SessionWorld(SessionWorld.library("clv"), "anna", "bert")) {
            laidOut(() -> new BoatsPanel(world.context));
            onEventThread(() -> {
                world.context.boats().select(List.of("anna", "bert"));
                return null;
            });

            get(world.session.fleet().disconnect("anna"));

            until(
                    "anna is gone",
                    () -> world.context.models().fleet().boat("anna").isEmpty());
            assertThat(onEventThread(() -> world.context.boats().boats())).containsExactly("bert");
        }
    }
}
