package org.sami.spn.json;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;

/** Where in a text the values of pointers begin. */
class JsonPlacesTest {
    private static final String TEXT = """
            {"id": "project",
              "plans": [
                {"name": "by name",
                 "id": "first", "a/b~c": [1, 22, {"x": null}]},
                {"places": [{"outputs": [{"id": "go"}]}]}
              ]
            }
            """;

    private static String place(String pointer) {
        JsonPlaces.Place place = JsonPlaces.find(TEXT, List.of(pointer)).get(pointer);
        return place.line() + ":" + place.column() + " " + place.element().orElse("-");
    }

    @Test
    void aValueIsWhereItsFirstCharacterStands() {
        assertThat(place("/id")).isEqualTo("1:8 -");
        assertThat(place("/plans")).isEqualTo("2:12 -");
        assertThat(place("/plans/0/a~1b~0c/1")).isEqualTo("4:34 first");
        assertThat(place("/plans/0/a~1b~0c/2/x")).isEqualTo("4:44 first");
        assertThat(place("/plans/1/places/0/outputs/0")).isEqualTo("5:30 go");
    }

    @Test
    void whatIsNotThereIsWhereTheNearestValueAroundItBegins() {
        assertThat(place("/plans/0/nothing/here")).isEqualTo("3:5 first");
        assertThat(place("/plans/7")).isEqualTo("2:12 -");
        assertThat(place("")).isEqualTo("1:1 -");
    }

    @Test
    void allPointersAreFoundInOnePass() {
        Map<String, JsonPlaces.Place> places =
                JsonPlaces.find(TEXT, List.of("/plans/1", "/plans/0", "/plans/0/id", "/plans/0"));

        assertThat(places).containsOnlyKeys("/plans/0", "/plans/1", "/plans/0/id");
        assertThat(places.get("/plans/0/id").line()).isEqualTo(4);
    }

    @Test
    void textThatIsNoJsonHasNoPlaces() {
        assertThat(JsonPlaces.find("{\"a\": [1, ", List.of("/a/0"))).isEmpty();
        assertThat(JsonPlaces.find("", List.of(""))).isEmpty();
    }
}
