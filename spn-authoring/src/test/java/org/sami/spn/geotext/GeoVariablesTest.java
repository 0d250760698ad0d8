package org.sami.spn.geotext;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;
import org.sami.spn.model.VariableSpec;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPath;
import org.sami.spn.value.ListValue;

class GeoVariablesTest {
    private static final String TRIANGLE = "45,10\n45.001,10\n45,10.001\n";
    private static final String KNOT = "45,10\n45.001,10.001\n45.001,10\n45,10.001\n";

    @Test
    void listsOfPointsAreAreasOrPathsAsTheUserSays() {
        GeoText text = text("[\n[\n" + TRIANGLE + "]\n[\n" + TRIANGLE + "]\n]");

        VariableSpec areas =
                GeoVariables.of(text, GeoMeaning.AREAS, "@a", false).variables().get(0);
        VariableSpec paths =
                GeoVariables.of(text, GeoMeaning.PATHS, "@a", false).variables().get(0);

        assertThat(((ListValue) areas.initial().orElseThrow()).items())
                .hasSize(2)
                .allMatch(GeoArea.class::isInstance);
        assertThat(((ListValue) paths.initial().orElseThrow()).items())
                .hasSize(2)
                .allMatch(GeoPath.class::isInstance);
        assertThat(areas.type()).isEqualTo(GeoMeaning.AREAS.type());
    }

    @Test
    void eachListCanHaveAVariableOfItsOwn() {
        GeoText text = text("[\n[\n" + TRIANGLE + "]\n[\n" + TRIANGLE + "]\n]");

        assertThat(GeoVariables.of(text, GeoMeaning.AREAS, "@bay", true).variables())
                .extracting(VariableSpec::name)
                .containsExactly("@bay1", "@bay2");
    }

    @Test
    void outlineThatReturnsToItsStartIsTheSameArea() {
        GeoText closed = text("[\n" + TRIANGLE + "45,10\n]");

        GeoArea area = (GeoArea) GeoVariables.of(closed, GeoMeaning.AREA, "@a", false)
                .variables()
                .get(0)
                .initial()
                .orElseThrow();

        assertThat(area.outline()).hasSize(3);
    }

    @Test
    void outlineThatCrossesItselfIsNoArea() {
        GeoVariables.Result result = GeoVariables.of(text("[\n" + KNOT + "]"), GeoMeaning.AREA, "@a", false);

        assertThat(result.variables()).isEmpty();
        assertThat(result.findings()).singleElement().satisfies(finding -> {
            assertThat(finding.line()).isEqualTo(1);
            assertThat(finding.message()).contains("crosses or touches itself");
        });
    }

    @Test
    void twoPointsAreAPathAndNoArea() {
        GeoText text = text("[\n45,10\n45.001,10\n]");

        assertThat(GeoVariables.of(text, GeoMeaning.PATH, "@a", false).variables())
                .hasSize(1);
        assertThat(GeoVariables.of(text, GeoMeaning.AREA, "@a", false)
                        .findings()
                        .get(0)
                        .message())
                .contains("three points or more");
    }

    @Test
    void severalBarePointsAreNotTheFirstOfThem() {
        GeoVariables.Result result = GeoVariables.of(text("1,2\n3,4\n"), GeoMeaning.POINT, "@a", false);

        assertThat(result.variables()).isEmpty();
        assertThat(result.findings().get(0).message()).contains("2 points");
    }

    private static GeoText text(String text) {
        return GeoTextReader.read(text.getBytes(StandardCharsets.UTF_8)).text().orElseThrow();
    }
}
