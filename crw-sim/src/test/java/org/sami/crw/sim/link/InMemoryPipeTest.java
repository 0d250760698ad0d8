package org.sami.crw.sim.link;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.sami.boat.link.Frame;
import org.sami.boat.link.Heartbeat;
import org.sami.crw.sim.clock.VirtualClock;

class InMemoryPipeTest {
    private final VirtualClock clock = new VirtualClock();
    private final List<String> arrived = new ArrayList<>();

    private InMemoryPipe pipe(long latencyMs, long jitterMs, double loss) {
        InMemoryPipe pipe = new InMemoryPipe(clock, new PipeConfig(latencyMs, jitterMs, loss), 3);
        pipe.connect((frame, nowMs) -> arrived.add(frame.sequence() + "@" + nowMs));
        return pipe;
    }

    private static Frame frame(int number) {
        return new Frame(number, "", new Heartbeat(0));
    }

    @Test
    void framesArriveAfterTheLatency() {
        InMemoryPipe pipe = pipe(20, 0, 0);
        pipe.send(frame(1));
        clock.runUntil(5);
        pipe.send(frame(2));
        clock.runUntil(19);
        assertThat(arrived).isEmpty();

        clock.runUntil(25);

        assertThat(arrived).containsExactly("1@20", "2@25");
    }

    @Test
    void framesNeverOvertakeOneAnother() {
        InMemoryPipe pipe = pipe(5, 50, 0);
        List<String> order = new ArrayList<>();
        pipe.connect((frame, nowMs) -> order.add(String.valueOf(frame.sequence())));
        List<String> sent = new ArrayList<>();
        for (int i = 0; i < 100; i++) {
            pipe.send(frame(i));
            sent.add(String.valueOf(i));
            clock.runUntil(clock.nowMs() + 3);
        }
        clock.runUntil(1000);

        assertThat(order).isEqualTo(sent);
    }

    @Test
    void losesItsPartOfTheFrames() {
        InMemoryPipe pipe = pipe(0, 0, 0.2);
        for (int i = 0; i < 10_000; i++) {
            pipe.send(frame(i));
        }
        clock.runUntil(0);

        assertThat(pipe.lost()).isBetween(1800L, 2200L);
        assertThat(pipe.delivered()).isEqualTo(10_000 - pipe.lost());
    }

    @Test
    void cutPipeTakesNothingButDeliversWhatIsUnderWay() {
        InMemoryPipe pipe = pipe(10, 0, 0);
        pipe.send(frame(1));
        pipe.setCut(true);
        pipe.send(frame(2));
        clock.runUntil(100);
        pipe.setCut(false);
        pipe.send(frame(3));
        clock.runUntil(200);

        assertThat(arrived).containsExactly("1@10", "3@110");
    }

    @Test
    void refusesLinksThatCannotBe() {
        assertThatThrownBy(() -> new PipeConfig(-1, 0, 0)).isInstanceOf(IllegalArgumentException.class);
        assertThatThrownBy(() -> new PipeConfig(0, 0, 1.1)).isInstanceOf(IllegalArgumentException.class);
        assertThatThrownBy(() -> new PipeConfig(0, 0, Double.NaN)).isInstanceOf(IllegalArgumentException.class);
    }
}
