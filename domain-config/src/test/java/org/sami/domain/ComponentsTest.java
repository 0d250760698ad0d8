package org.sami.domain;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.sami.spn.component.ChosenComponent;
import org.sami.spn.component.ComponentChoice;
import org.sami.spn.component.ComponentLibrary;
import org.sami.spn.component.ComponentType;
import org.sami.spn.component.Interaction;
import org.sami.spn.component.Interactions;
import org.sami.spn.component.MarkupOption;
import org.sami.spn.component.Purpose;
import org.sami.spn.component.TypePattern;
import org.sami.spn.component.WidgetType;
import org.sami.spn.finding.Finding;
import org.sami.spn.json.ComponentReader;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.json.Reading;
import org.sami.spn.value.TypeNames;
import org.sami.spn.vocabulary.EventType;

/** The components that ship with the boats domain, and what is chosen of them (thesis 5.2.4). */
class ComponentsTest {
    private static final DomainLibrary CRW =
            DomainLibrary.fromClassPath("/org/sami/domain/crw").orThrow();
    private static final ComponentLibrary COMPONENTS = CRW.components();
    private static final ComponentChoice CHOICE =
            new ComponentChoice(COMPONENTS, CRW.vocabulary().types());

    private static String text(ChosenComponent chosen) {
        if (chosen instanceof ChosenComponent.Direct direct) {
            String widgets = direct.widgets().stream().map(w -> "+" + w.name()).collect(Collectors.joining());
            return direct.component().name() + widgets;
        }
        if (chosen instanceof ChosenComponent.Repeated repeated) {
            return "each(" + text(repeated.element()) + ")";
        }
        if (chosen instanceof ChosenComponent.Entries entries) {
            return "entries(" + text(entries.key()) + " " + text(entries.value()) + ")";
        }
        if (chosen instanceof ChosenComponent.Form form) {
            return form.fields().entrySet().stream()
                    .map(field -> field.getKey() + ":" + text(field.getValue()))
                    .collect(Collectors.joining(" ", "form(", ")"));
        }
        return "warning: " + ((ChosenComponent.Warning) chosen).reason();
    }

    /** The golden table: what type, for what, with which markup, is shown or asked with what. */
    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '`', textBlock = """
            create | text                  |                                                     | TextField | 0
            create | text                  | Description.source Filter                           | TextField | 1
            create | real                  | Description.source                                  | NumberField | 1
            create | duration              | Description.source                                  | DurationField | 0
            create | boolean               | Attention.type=BLINK Attention.end=ON_CLICK         | YesNoButtons | 2
            create | Rank                  | DefaultSelection.selection=ALL                      | ChoiceList | 1
            create | point                 | DefaultLocation.location=QUAY                       | Map | 1
            create | list<point>           | RelevantArea.source=POINT RelevantInformation.source | Map+ReadingLayer | 2
            create | area                  | RelevantProxy.proxy=ALL_PROXIES RelevantProxy.showPath=true | Map+ProxyLayer+PathLayer | 2
            create | list<proxy>           | Sort.method=ALPHABETICAL                            | ProxyList | 1
            create | map<task,proxy>       |                                                     | AllocationTable | 0
            create | map<proxy,text>       |                                                     | entries(ProxyList TextField) | 0
            create | BoatId                |                                                     | form(name:TextField color:TextField server:TextField imageStorageDirectory:TextField) | 0
            create | list<BoatId>          | Description.source                                  | each(form(name:TextField color:TextField server:TextField imageStorageDirectory:TextField)) | 1
            create | any                   |                                                     | warning: No component can ask for a value of type any | -1
            select | list<proxy>           | Sort.method=CHRONOLOGICAL Filter.source Filter.action=INCLUDE | ProxyList+FilterBar | 3
            select | list<proxy>           | RelevantProxy.showPath=true                         | Map+ProxyLayer+PathLayer | 1
            select | list<proxy>           | RelevantProxy.showPath=true RelevantProxy.showData=true RelevantInformation.source | Map+ProxyLayer+PathLayer+ReadingLayer | 3
            select | map<proxy,path>       |                                                     | Map+PathLayer | 0
            select | map<proxy,point>      | RelevantInformation.visualization=CONTOUR           | Map+ProxyLayer+ReadingLayer | 1
            select | list<Allocation>      |                                                     | OptionPager | 0
            select | list<Allocation>      | SelectionOptions.number SelectionOptions.format=TABS | OptionTabs | 2
            select | list<Allocation>      | SelectionOptions.format=STACKED                     | OptionStack | 1
            select | list<PathOption>      | SelectionOptions.format=TABS RelevantArea.source=AREA | OptionTabs+OptionPreview | 2
            select | list<map<proxy,path>> | SelectionOptions.format=TABS RelevantArea.source=AREA | OptionTabs+OptionPreview | 2
            select | list<text>            | Sort.method=ALPHABETICAL Filter.source              | ChoiceList+FilterBar | 2
            select | list<variable>        | Sort.method=CHRONOLOGICAL                           | VariableList | 0
            select | map<proxy,list<text>> |                                                     | entries(ProxyList ChoiceList) | 0
            """)
    void typeWithMarkupGetsItsComponentsAndScore(
            String purpose, String type, String markups, String chosen, int score) {
        List<MarkupOption> wanted = markups == null
                ? List.of()
                : Arrays.stream(markups.split(" "))
                        .map(option -> MarkupOption.parse(option).orElseThrow())
                        .toList();

        ChosenComponent result = CHOICE.choose(
                Purpose.valueOf(purpose.toUpperCase(Locale.ROOT)),
                TypeNames.parse(type).orElseThrow(),
                wanted);

        assertThat(text(result)).isEqualTo(chosen);
        assertThat(result.score()).isEqualTo(score);
    }

    @Test
    void noComponentCanDoEverything() {
        assertThat(COMPONENTS.components()).hasSizeGreaterThanOrEqualTo(8);
        Set<TypePattern> allTypes = new HashSet<>();
        Set<MarkupOption> allMarkups = new HashSet<>();
        COMPONENTS.components().forEach(component -> {
            allTypes.addAll(component.can().selects());
            allMarkups.addAll(component.can().markups());
        });
        for (ComponentType component : COMPONENTS.components()) {
            assertThat(component.can().selects()).as(component.name()).isNotEqualTo(allTypes);
            assertThat(allMarkups)
                    .as(component.name())
                    .anyMatch(option -> !component.can().actsOn(option));
        }
    }

    @Test
    void everyWidgetCanBePutOnSomeComponent() {
        assertThat(COMPONENTS.components().stream()
                        .flatMap(component -> component.widgets().stream())
                        .collect(Collectors.toSet()))
                .containsExactlyInAnyOrderElementsOf(COMPONENTS.widgets());
        assertThat(COMPONENTS.widgets()).extracting(WidgetType::name).doesNotHaveDuplicates();
    }

    @Test
    void everyEventThatAsksTheOperatorHasComponents() {
        Interactions interactions = new Interactions(CRW.vocabulary());
        int asked = 0;
        for (EventType event : CRW.vocabulary().events().values()) {
            Optional<Interaction> interaction = interactions.of(event, List.of());
            if (event.decision().isPresent() && interaction.isPresent()) {
                asked++;
                assertThat(CHOICE.choose(interaction.get()).score())
                        .as(event.name())
                        .isNotEqualTo(ChosenComponent.NONE);
            }
        }
        assertThat(asked).isGreaterThanOrEqualTo(10);
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '`', textBlock = """
            "formatVersion": 1  | "formatVersion": 2  | E-VERSION        | /formatVersion
            "Label"]            | "Lable"]            | E-UNKNOWN-WORD   | /components/0/widgets
            "point"             | "pint"              | E-UNKNOWN-TYPE   | /components/0/creates/0
            "Sort.order"        | "Sort.oder"         | E-UNKNOWN-WORD   | /components/0/markups/0
            "Sort.order"        | "Sort..order"       | E-BAD-VALUE      | /components/0/markups/0
            "Sort.order"        | "Srot"              | E-UNKNOWN-WORD   | /components/0/markups/0
            "Sort.order"        | "Sort.order=UP"     | E-UNKNOWN-WORD   | /components/0/markups/0
            "Sort.order"        | 3                   | E-BAD-VALUE      | /components/0/markups/0
            "creates"           | "create"            | E-UNKNOWN-MEMBER | /components/0/create
            "name": "Map"       | "name": "Grid"      | E-DUPLICATE      | /components/1
            """)
    void whatIsWrongIsNamedWithItsPlace(String right, String wrong, String code, String where) {
        String good = """
                {"formatVersion": 1,
                 "widgets": [{"name": "Label", "help": "A label.", "selects": ["text"]}],
                 "components": [
                   {"name": "Map", "help": "A map.", "creates": ["point"], "markups": ["Sort.order"], "widgets": ["Label"]},
                   {"name": "Grid", "help": "A grid.", "selects": ["point"]}]}
                """;
        assertThat(ComponentReader.read(good, CRW.vocabulary()).findings()).isEmpty();
        assertThat(good).contains(right);

        Reading<ComponentLibrary> reading = ComponentReader.read(good.replace(right, wrong), CRW.vocabulary());

        assertThat(reading.result()).isEmpty();
        assertThat(reading.findings()).extracting(Finding::code).contains(code);
        assertThat(reading.findings().toString()).contains(where);
    }
}
