package org.sami.dreamm.learn;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.sami.lessons.course.CourseFiles;
import org.sami.lessons.course.CourseReader;
import org.sami.picture.NetFonts;
import org.sami.spn.drawing.NetDrawing;
import org.sami.spn.drawing.NetLayout;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.model.Plan;

/** Pictures of a lesson next to the editor. */
class PictureLayoutTest {
    private static final DomainLibrary BOATS =
            DomainLibrary.fromClassPath("/org/sami/domain/crw").orThrow();

    @Test
    void pictureThatIsTooWideComesNearerFromLeftToRightAndGrowsNoTaller() {
        Plan plan = CourseReader.read(CourseFiles.SHIPPED, BOATS)
                .orThrow()
                .project("02-places", "keep-1")
                .orElseThrow()
                .plans()
                .get(0);
        NetDrawing own = NetLayout.given(plan, BOATS.vocabulary(), NetFonts::width);

        NetDrawing near =
                PictureLayout.of(plan, BOATS.vocabulary(), own.bounds().width() * 0.8);

        assertThat(near.bounds().width()).isLessThanOrEqualTo(own.bounds().width() * 0.8);
        assertThat(near.bounds().height()).isCloseTo(own.bounds().height(), within(30.0));
    }
}
