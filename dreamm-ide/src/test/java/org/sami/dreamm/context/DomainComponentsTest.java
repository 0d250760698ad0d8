package org.sami.dreamm.context;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.dreamm.document.ProjectDocument;
import org.sami.dreamm.profile.Profile;
import org.sami.spn.component.ChosenComponent;
import org.sami.spn.component.ComponentChoice;
import org.sami.spn.component.Purpose;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.value.ValueType;

/** An author gives values in each domain that ships, also in one that declares no components of its own. */
class DomainComponentsTest {
    @ParameterizedTest
    @ValueSource(strings = {"crw", "uav", "team"})
    void pointCanBeGiven(String domain) {
        DomainSource source = DomainSource.of(Optional.of(Path.of(domain)));
        DomainLibrary library = source.library().orThrow();
        DreammContext context = new DreammContext(
                source,
                library,
                new ProjectDocument(library.vocabulary(), library.combined(), Optional.empty()),
                Profile.ALL);

        ChosenComponent chosen = new ComponentChoice(
                        context.components(), context.vocabulary().types())
                .choose(Purpose.CREATE, ValueType.Simple.POINT, List.of());

        assertThat(chosen).isNotInstanceOf(ChosenComponent.Warning.class);
    }
}
