package org.sami.crw.session;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.operator.OperatorModels;
import org.sami.crw.operator.health.HealthEntry;
import org.sami.crw.operator.health.HealthKind;
import org.sami.crw.proxy.link.LinkLosses;
import org.sami.crw.proxy.status.BoatStatus;
import org.sami.crw.proxy.status.LinkState;
import org.sami.spn.protocol.Priority;

/** What the session's health says of a link that comes and goes. */
class LinkWatchTest {
    private long nowMillis;
    private final OperatorModels models = new OperatorModels(Runnable::run, () -> nowMillis);
    private final LinkWatch watch = new LinkWatch(models.health());

    private void becomes(LinkState link, long afterSeconds) {
        nowMillis += afterSeconds * 1000;
        watch.take(new FleetEvent.LinkChanged(BoatStatus.unknown("anna").with(link, "boot")), nowMillis);
    }

    private List<HealthEntry> entries() {
        return models.health().snapshot().of(HealthKind.LINK);
    }

    @Test
    void linkThatIsLostAgainAndAgainIsAFaultThatSaysWhatIsSoNow() {
        becomes(LinkState.LINKED, 0);
        becomes(LinkState.LOST, 10);
        becomes(LinkState.LINKED, 30);
        becomes(LinkState.LOST, 30);
        becomes(LinkState.LINKED, 30);
        assertThat(entries()).isEmpty();

        becomes(LinkState.LOST, 30);

        assertThat(entries()).singleElement().satisfies(entry -> {
            assertThat(entry.fault().text()).isEqualTo("The link to anna was lost 3 times in 2 min and is lost now");
            assertThat(entry.severity()).isEqualTo(Priority.HIGH);
            assertThat(entry.fault().boat()).isEqualTo("anna");
        });

        becomes(LinkState.LINKED, 5);

        assertThat(entries()).singleElement().satisfies(entry -> {
            assertThat(entry.fault().text()).isEqualTo("The link to anna was lost 3 times in 2 min; it stands now");
            assertThat(entry.severity()).isEqualTo(Priority.MEDIUM);
        });
    }

    @Test
    void faultIsOverWhenTheLinkHasStoodForAWhile() {
        for (int i = 0; i < 4; i++) {
            becomes(LinkState.LINKED, 10);
            becomes(LinkState.LOST, 10);
        }
        becomes(LinkState.LINKED, 10);
        nowMillis += LinkLosses.WINDOW_MS - 60_000;
        watch.look(nowMillis);
        assertThat(entries()).hasSize(1);

        nowMillis += 60_000;
        watch.look(nowMillis);

        assertThat(entries()).isEmpty();
    }

    @Test
    void boatThatIsGivenUpHasNoFaultLeft() {
        for (int i = 0; i < 3; i++) {
            becomes(LinkState.LINKED, 10);
            becomes(LinkState.LOST, 10);
        }
        assertThat(entries()).hasSize(1);

        watch.take(new FleetEvent.Removed("anna"), nowMillis);

        assertThat(entries()).isEmpty();
    }
}
