package org.sami.dreamm.canvas;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.event.InputEvent;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Random;
import java.util.Set;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.spn.drawing.NetDrawing.Vertex;
import org.sami.spn.model.Project;

/** Whatever an author does on the net can be taken back and made again, to equal bytes. */
@Tag("long")
class RandomGesturesTest {
    private static final int GESTURES = 700;
    private static final String[] KEYS = {
        "P",
        "T",
        "ctrl D",
        "ctrl C",
        "ctrl V",
        "ctrl shift V",
        "DELETE",
        "ctrl DOWN",
        "ctrl RIGHT",
        "ctrl shift LEFT",
        "alt shift LEFT",
        "alt shift X",
        "alt shift R",
        "X",
        "R",
        "RIGHT",
        "LEFT",
        "UP",
        "DOWN",
        "shift RIGHT",
        "E",
        "Q"
    };

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3})
    void areUndoneAndRedoneToEqualBytes(long seed) {
        Random random = new Random(seed);
        try (EditorScene scene = EditorScene.of("clv")) {
            String first = scene.text();
            List<Project> versions =
                    new ArrayList<>(List.of(scene.context.document().project()));
            scene.context.document().addListener(change -> versions.add(change.after()));
            for (int i = 0; i < GESTURES; i++) {
                gesture(scene, random);
            }
            String last = scene.text();
            List<Project> made = List.copyOf(versions);
            assertThat(made).hasSizeGreaterThan(GESTURES / 4);

            for (int i = made.size() - 2; i >= 0; i--) {
                scene.context.undo();
                assertThat(scene.context.document().project()).isEqualTo(made.get(i));
            }
            assertThat(scene.text()).isEqualTo(first);
            while (scene.context.document().redoLabel().isPresent()) {
                scene.context.redo();
            }
            assertThat(scene.text()).isEqualTo(last);
        }
    }

    private static void gesture(EditorScene scene, Random random) {
        List<Vertex> vertices = scene.view.net().drawing().vertices();
        switch (random.nextInt(5)) {
            case 0 -> {
                if (!vertices.isEmpty()) {
                    scene.click(any(vertices, random).id(), random.nextBoolean() ? InputEvent.SHIFT_DOWN_MASK : 0);
                }
            }
            case 1 -> {
                if (!vertices.isEmpty()) {
                    scene.drag(
                            scene.pixel(any(vertices, random).id()),
                            random.nextInt(300) - 150,
                            random.nextInt(300) - 150,
                            0);
                }
            }
            case 2 -> {
                Set<String> some = new LinkedHashSet<>();
                vertices.stream().filter(v -> random.nextInt(6) == 0).forEach(v -> some.add(v.id()));
                scene.context.editor().select(some);
            }
            case 3 -> {
                if (vertices.size() > 1) {
                    scene.context.editor().select(Set.of(any(vertices, random).id()));
                    scene.key("C");
                    scene.key(random.nextBoolean() ? "RIGHT" : "LEFT");
                    scene.key("ENTER");
                    scene.key("ESCAPE");
                }
            }
            default -> scene.key(KEYS[random.nextInt(KEYS.length)]);
        }
        if (scene.plan().places().size() > 40) {
            scene.key("ctrl A");
            scene.key("DELETE");
        }
    }

    private static Vertex any(List<Vertex> vertices, Random random) {
        return vertices.get(random.nextInt(vertices.size()));
    }
}
