package org.sami.dreamm.canvas;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.awt.image.BufferedImage;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.picture.net.NetMode;
import org.sami.spn.legacy.LegacyImport;
import org.sami.spn.legacy.LegacyTableReader;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;

/** Plans that others have written are opened and drawn, and are saved as they were. */
@Tag("long")
class CorpusTest {
    @ParameterizedTest
    @ValueSource(strings = {"thesis", "crw"})
    void theFieldsPlansAreOpenedDrawnAndSavedUnchanged(String name) {
        Path file = Path.of("../../shared/legacy-plans", name + ".json");
        assumeTrue(Files.exists(file), "skipped: " + file + " is not here");
        Project project = new LegacyImport(
                        EditorScene.DOMAIN.vocabulary(),
                        LegacyTableReader.fromClassPath(
                                        "/org/sami/domain/crw/legacy.json", EditorScene.DOMAIN.vocabulary())
                                .orThrow())
                .read(file)
                .project()
                .orElseThrow();

        assertOpenedDrawnAndUnchanged(project);
    }

    @Test
    void theLibraryIsOpenedDrawnAndSavedUnchanged() {
        assertOpenedDrawnAndUnchanged(EditorScene.DOMAIN.combined());
    }

    private static void assertOpenedDrawnAndUnchanged(Project project) {
        try (EditorScene scene = new EditorScene(project)) {
            String before = scene.text();
            scene.context.editor().setMode(NetMode.ALL);
            for (Plan plan : project.plans()) {
                scene.context.editor().open(plan.id());
                scene.view.net().fit();
                assertThat(scene.view.net().drawing().vertices())
                        .hasSize(plan.places().size() + plan.transitions().size());
                if (!plan.places().isEmpty()) {
                    assertThat(colours(scene.paint())).as(plan.id()).isGreaterThan(8);
                }
            }
            assertThat(scene.context.document().isModified()).isFalse();
            assertThat(scene.text()).isEqualTo(before);
        }
    }

    private static long colours(BufferedImage image) {
        return Arrays.stream(image.getRGB(0, 50, image.getWidth(), image.getHeight() - 50, null, 0, image.getWidth()))
                .distinct()
                .count();
    }
}
