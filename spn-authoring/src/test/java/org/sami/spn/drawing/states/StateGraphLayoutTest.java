package org.sami.spn.drawing.states;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CancellationException;
import org.junit.jupiter.api.Test;
import org.sami.spn.drawing.DrawingBox;
import org.sami.spn.drawing.TextMeasure;
import org.sami.spn.drawing.states.StateGraph.Arrow;
import org.sami.spn.drawing.states.StateGraph.Kind;
import org.sami.spn.drawing.states.StateGraph.State;

class StateGraphLayoutTest {
    private static final TextMeasure MEASURE = (text, style) -> text.length() * style.size() * 0.55;

    private static StateGraph diamond() {
        return new StateGraph(
                "a diamond",
                "all 5 states",
                List.of(
                        new State("0", List.of("start"), Kind.INNER),
                        new State("1", List.of("left"), Kind.INNER),
                        new State("2", List.of("right with a name that needs several lines in its box"), Kind.INNER),
                        new State("3 · deadlock", List.of("together*2"), Kind.DEADLOCK),
                        new State("4", List.of("loop"), Kind.NOT_FOLLOWED)),
                List.of(
                        new Arrow(0, 1, List.of("go left")),
                        new Arrow(0, 2, List.of("go right")),
                        new Arrow(1, 3, List.of("a", "b", "c", "d")),
                        new Arrow(2, 3, List.of("meet")),
                        new Arrow(2, 0, List.of("back")),
                        new Arrow(1, 4, List.of("on")),
                        new Arrow(1, 1, List.of("stay"))));
    }

    private static StateGraphDrawing drawn() {
        return StateGraphLayout.of(diamond(), MEASURE, () -> false);
    }

    @Test
    void nothingLiesOnAnotherBoxOrLabel() {
        StateGraphDrawing drawing = drawn();
        List<DrawingBox> all = new ArrayList<>();
        drawing.boxes().forEach(box -> all.add(box.area()));
        drawing.lines().forEach(line -> all.add(line.label()));

        assertThat(all).hasSize(12).allMatch(drawing.bounds()::contains);
        for (int i = 0; i < all.size(); i++) {
            for (int j = 0; j < i; j++) {
                assertThat(all.get(i).intersects(all.get(j)))
                        .as(i + " and " + j)
                        .isFalse();
            }
        }
    }

    @Test
    void initialStateIsAboveTheOthers() {
        List<StateGraphDrawing.Box> boxes = drawn().boxes();

        assertThat(boxes.subList(1, 5))
                .allMatch(box -> box.area().y() >= boxes.get(0).area().maxY());
    }

    @Test
    void boxesLabelsAndLinesAreFoundAtTheirPoints() {
        StateGraphDrawing drawing = drawn();
        for (int i = 0; i < 5; i++) {
            DrawingBox area = drawing.boxes().get(i).area();
            assertThat(drawing.stateAt(area.x() + 2, area.y() + 2)).hasValue(i);
            assertThat(drawing.arrowAt(area.x() + area.width() / 2, area.y() + area.height() / 2))
                    .isEmpty();
        }
        for (int i = 0; i < drawing.lines().size(); i++) {
            DrawingBox label = drawing.lines().get(i).label();
            assertThat(drawing.arrowAt(label.x() + 1, label.y() + 1)).hasValue(i);
            assertThat(drawing.stateAt(label.x() + 1, label.y() + 1)).isEmpty();
        }
    }

    @Test
    void manyFiringsBetweenTwoStatesAreCounted() {
        assertThat(diamond().arrows().get(2).lines()).containsExactly("a", "b", "and 2 more");
        assertThat(diamond().arrows().get(0).lines()).containsExactly("go left");
    }

    @Test
    void layoutEndsWhenItIsCancelled() {
        assertThatThrownBy(() -> StateGraphLayout.of(diamond(), MEASURE, () -> true))
                .isInstanceOf(CancellationException.class);
    }

    @Test
    void arrowsLeadToStatesThatAreThere() {
        List<State> one = List.of(new State("0", List.of(), Kind.END));
        List<Arrow> away = List.of(new Arrow(0, 1, List.of()));

        assertThatThrownBy(() -> new StateGraph("", "", one, away)).isInstanceOf(IllegalArgumentException.class);
    }

    @Test
    void dotQuotesWhatNamesContain() {
        StateGraph graph = new StateGraph(
                "a \"net\"",
                "all 2 states",
                List.of(
                        new State("0", List.of("p\\q", "r"), Kind.INNER),
                        new State("1 · deadlock", List.of("(no token)"), Kind.DEADLOCK)),
                List.of(new Arrow(0, 1, List.of("t1", "t2"))));

        assertThat(StateGraphDot.of(graph)).isEqualTo("""
            digraph states {
              label="a \\"net\\"\\nall 2 states";
              node [shape=box, style=rounded];
              s0 [label="0\\np\\\\q r", penwidth=2];
              s1 [label="1 · deadlock\\n(no token)", color=red, fontcolor=red];
              s0 -> s1 [label="t1\\nt2"];
            }
            """);
    }
}
