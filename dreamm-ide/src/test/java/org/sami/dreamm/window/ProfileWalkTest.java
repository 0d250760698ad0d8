package org.sami.dreamm.window;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Component;
import java.awt.Container;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import javax.swing.AbstractButton;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JSpinner;
import javax.swing.JTextField;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.io.TempDir;
import org.sami.dreamm.OnEventThread;
import org.sami.dreamm.context.DreammContext;
import org.sami.dreamm.document.ProjectDocument;
import org.sami.dreamm.export.ExportCommands;
import org.sami.dreamm.file.FileCommands;
import org.sami.dreamm.file.RecentProjects;
import org.sami.dreamm.file.RecoveryFolder;
import org.sami.dreamm.inspector.InspectorPanel;
import org.sami.dreamm.issues.LiveFindings;
import org.sami.dreamm.learn.mode.LessonProfile;
import org.sami.dreamm.profile.Profile;
import org.sami.dreamm.profile.ProfileFile;
import org.sami.dreamm.profile.ProfileGuard;
import org.sami.dreamm.profile.ProfileIds;
import org.sami.lessons.course.CourseFiles;
import org.sami.lessons.course.CourseReader;
import org.sami.lessons.course.Lesson;
import org.sami.palette.Theme;
import org.sami.picture.net.NetScene;
import org.sami.spn.edit.PlanBuilder;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.model.Action;
import org.sami.spn.model.FieldSource;
import org.sami.spn.model.FrameColor;
import org.sami.spn.model.InRequirement;
import org.sami.spn.model.LayoutPoint;
import org.sami.spn.model.MarkupSpec;
import org.sami.spn.model.Match;
import org.sami.spn.model.NetFrame;
import org.sami.spn.model.OutRequirement;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.TaskSpec;
import org.sami.spn.model.TokenKind;
import org.sami.spn.model.VariableSpec;
import org.sami.spn.value.EnumValue;
import org.sami.spn.value.RealValue;
import org.sami.spn.value.ValueType;
import org.sami.ui.EventThread;
import org.sami.ui.check.Layout;
import org.sami.ui.dock.DockPanel;
import org.sami.ui.look.Look;
import org.sami.ui.window.ViewCommands;
import org.sami.ui.window.WindowSettings;

/** Walks all that the window has, without a window: each command, panel, field and choice goes where a profile hides or locks its id. */
@Tag("long")
@ExtendWith(OnEventThread.class)
class ProfileWalkTest {
    private static final DomainLibrary BOATS =
            DomainLibrary.fromClassPath("/org/sami/domain/crw").orThrow();
    private static final Path PROFILES = Path.of("..", "docs", "profiles");

    /** Those that hold others. */
    private static final Set<String> HOLDERS = Set.of(
            "event",
            "event-field",
            "event-markups",
            "sub-mission",
            "inspector-add-event",
            "inspector-edge",
            "plan-tasks",
            "plan-variables",
            "project-variables",
            "try-tab-steps",
            "try-tab-state",
            "try-tab-marking",
            "try-tab-cases");

    /** Those that are no component of their own. */
    private static final Set<String> UNSEEN = Set.of(
            "net-move",
            "net-drop",
            "plan-move",
            ProfileIds.MISSING_REQUIREMENT,
            "event-field-sources",
            "inspector-fix");

    private static Path data;

    private final List<Runnable> closing = new ArrayList<>();

    @BeforeAll
    static void keepDataIn(@TempDir Path folder) {
        data = folder;
        EventThread.get(() -> {
            Look.apply(Theme.LIGHT, 100);
            return null;
        });
    }

    @AfterEach
    void close() {
        closing.forEach(Runnable::run);
    }

    /** What a window is made of. */
    private record Parts(DreammContext context, DreammPanels panels, JComponent counters) {
        Set<String> ids() {
            Set<String> ids = new WindowIds(context, panels).all();
            ids.addAll(Set.of("panels-reset", "end")); // of the frame
            return ids;
        }
    }

    private Parts open(Profile profile) throws IOException {
        DreammContext context =
                new DreammContext(BOATS, new ProjectDocument(BOATS.vocabulary(), project(), Optional.empty()), profile);
        WindowSettings settings = new WindowSettings(data.resolve("window.properties"));
        FileCommands files = new FileCommands(
                context,
                null,
                new RecentProjects(settings),
                RecoveryFolder.take(Files.createTempDirectory(data, "recovery"), BOATS.vocabulary()));
        EditCommands.addTo(context);
        ExportCommands.addTo(context);
        RunParts run = new RunParts(context);
        DreammPanels panels = new DreammPanels(context, run);
        new ViewCommands(context.commands(), null, settings);
        JComponent counters = run.counters();
        new ProfileGuard(profile).guard(counters);
        closing.add(() -> {
            files.close();
            run.close();
            context.close();
        });
        return new Parts(context, panels, counters);
    }

    /** A plan that has something of each kind. */
    private static Project project() {
        Plan child = new PlanBuilder("child")
                .start("c")
                .end("over")
                .variable(new VariableSpec("@there", ValueType.Simple.POINT, Optional.empty()))
                .build();
        Plan plan = new PlanBuilder("walk")
                .start("ask")
                .output("ask", "OperatorSelectBoatList", all())
                .output(
                        "ask",
                        "AssembleLocationRequest",
                        Map.of(
                                "location",
                                new FieldSource.FromVariable("@point"),
                                "spacing",
                                new FieldSource.Asked(Optional.of(new RealValue(10)), true)),
                        Map.of())
                .transition("chosen", "OperatorSelectsBoatList", "AssembleLocationResponse")
                .in("ask", "chosen", InRequirement.of(TokenKind.ANY_PROXY, Match.AT_LEAST, 2))
                .out("chosen", "over", new OutRequirement(TokenKind.TASK, 1, Action.TAKE, "look"))
                .sub("nested", "child")
                .in("nested", "chosen", InRequirement.of(TokenKind.RELEVANT, Match.AT_LEAST, 1))
                .out("chosen", "nested", OutRequirement.of(Action.ADD, OutRequirement.ALL, TokenKind.ANY_PROXY))
                .end("over")
                .variable(new VariableSpec("@point", ValueType.Simple.POINT, Optional.empty()))
                .task(new TaskSpec("look", "Camera", Map.of()))
                .build()
                .withFrames(List.of(new NetFrame("Walk", FrameColor.BLUE, new LayoutPoint(0, 0), 100, 80)));
        VariableSpec global = new VariableSpec("@home", ValueType.Simple.POINT, Optional.empty());
        return new Project("walk", "", "crw", List.of(global), List.of(), List.of(plan, child));
    }

    private static MarkupSpec all() {
        return new MarkupSpec("DefaultSelection", Map.of("selection", new EnumValue("SelectionDefault", "ALL")));
    }

    /** All components of all panels, with each kind of thing selected, by the ids of profiles. */
    private static Map<String, List<Component>> walk(Parts parts) {
        Map<String, List<Component>> found = new LinkedHashMap<>();
        for (Set<String> selection : List.of(
                Set.<String>of(),
                Set.of("ask"),
                Set.of("chosen"),
                Set.of("nested"),
                Set.of("over"),
                Set.of(NetScene.idOfFrame(0)),
                Set.of("i0"),
                Set.of("o0"))) {
            parts.context().editor().open("walk");
            parts.context().editor().select(selection);
            for (DockPanel panel : parts.panels().all()) {
                Layout.find(panel, "palette-search", JTextField.class).ifPresent(text -> text.setText("execute path"));
                Layout.find(panel, "event-add-markup", JComboBox.class)
                        .ifPresent(markups -> markups.setSelectedItem("Priority"));
                collect(panel, found);
            }
        }
        collect(parts.counters(), found);
        return found;
    }

    private static void collect(Component at, Map<String, List<Component>> found) {
        found.computeIfAbsent(ProfileGuard.idOf(at), id -> new ArrayList<>()).add(at);
        if (at instanceof Container container) {
            for (Component child : container.getComponents()) {
                collect(child, found);
            }
        }
    }

    /** The ids of components: what is chosen in them goes by ids of its own. */
    private static Set<String> fields() {
        return ProfileIds.fixed().stream()
                .filter(id -> !UNSEEN.contains(id) && !id.startsWith("requirement-") && !id.startsWith("event-source-"))
                .collect(Collectors.toCollection(LinkedHashSet::new));
    }

    private static Profile hiding(Set<String> ids) {
        return new Profile("walk", List.copyOf(ids), List.of(), List.of());
    }

    private static Profile locking(Set<String> ids) {
        return new Profile("walk", List.of(), List.copyOf(ids), List.of());
    }

    @Test
    void everyFieldIsThereUnlessTheProfileHidesItAndIsDisabledWhereItIsLocked() throws IOException {
        Map<String, List<Component>> whole = walk(open(Profile.ALL));
        assertThat(whole.keySet()).as("ids of fields").containsAll(fields());

        Set<String> inner = new LinkedHashSet<>(fields());
        inner.removeAll(HOLDERS);
        assertThat(walk(open(hiding(inner))).keySet()).doesNotContainAnyElementsOf(inner);
        assertThat(walk(open(hiding(HOLDERS))).keySet()).doesNotContainAnyElementsOf(HOLDERS);

        Map<String, List<Component>> locked = walk(open(locking(fields())));
        for (String id : fields()) {
            assertThat(locked.get(id)).as(id).isNotEmpty().noneMatch(Component::isEnabled);
        }
    }

    @Test
    void everyFieldThatAPersonUsesHasAnIdOrStandsInOne() throws IOException {
        Parts parts = open(Profile.ALL);
        Set<String> ids = parts.ids();

        Set<String> without = new TreeSet<>();
        walk(parts)
                .values()
                .forEach(components -> components.stream()
                        .filter(c -> c instanceof AbstractButton
                                || c instanceof JTextField
                                || c instanceof JComboBox<?>
                                || c instanceof JSpinner)
                        .filter(c -> !c.getClass().getName().startsWith("com.formdev"))
                        .filter(c -> !"more-commands".equals(c.getName())) // holds commands, by their ids
                        .filter(c -> !standsIn(c, ids))
                        .forEach(c ->
                                without.add(c.getName() + " " + c.getClass().getSimpleName())));

        assertThat(without).isEmpty();
    }

    private static boolean standsIn(Component component, Set<String> ids) {
        for (Component at = component; at != null; at = at.getParent()) {
            if (ids.contains(ProfileGuard.idOf(at))) {
                return true;
            }
        }
        return false;
    }

    @Test
    void everyCommandIsHiddenOrLockedByTheProfileThatNamesIt() throws IOException {
        Set<String> ids = Set.copyOf(open(Profile.ALL).context().commands().ids());
        assertThat(ids).hasSizeGreaterThan(100).allMatch(id -> id.matches("[a-z0-9]+(-[a-z0-9]+)*"));

        assertThat(open(hiding(ids)).context().commands().all()).isEmpty();
        assertThat(open(locking(ids)).context().commands().all())
                .hasSameSizeAs(ids)
                .allSatisfy(command -> {
                    assertThat(command.isEnabled()).isFalse();
                    assertThat(command.whyNot()).contains("the profile walk does not have it");
                });
    }

    @Test
    void everyPanelIsLeftOutByTheProfileThatNamesIt() throws IOException {
        List<String> ids = open(Profile.ALL).panels().profileIds();
        for (Set<String> half : List.of(Set.copyOf(ids.subList(0, 4)), Set.copyOf(ids.subList(4, ids.size())))) {
            assertThat(open(hiding(half)).panels().all())
                    .extracting(panel -> "panel-" + panel.getPersistentID())
                    .containsExactlyElementsOf(
                            ids.stream().filter(id -> !half.contains(id)).toList());
        }
    }

    @Test
    void everyKindOfRequirementAndSourceIsNotOfferedWhereTheProfileHidesOrLocksIt() {
        Map<String, Set<String>> whole = offers(Profile.ALL);
        List<String> choices = ProfileIds.fixed().stream()
                .filter(id -> id.startsWith("requirement-") || id.startsWith("event-source-"))
                // what is chosen now stays in its choice
                .filter(id -> !Set.of("requirement-in-any-proxy", "requirement-match-at-least", "event-source-variable")
                        .contains(id))
                .toList();
        for (int i = 0; i < choices.size(); i++) {
            String id = choices.get(i);
            Map<String, Set<String>> left = offers(i % 2 == 0 ? hiding(Set.of(id)) : locking(Set.of(id)));
            Set<String> gone = new TreeSet<>();
            whole.forEach((kind, offers) -> offers.stream()
                    .filter(offer -> !left.get(kind).contains(offer))
                    .forEach(offer -> gone.add(kind + offer)));
            assertThat(gone).containsExactly(id);
        }
    }

    /** What the choices of edges and of a field's source offer next to what is chosen, by the beginning of their ids. */
    private static Map<String, Set<String>> offers(Profile profile) {
        DreammContext context =
                new DreammContext(BOATS, new ProjectDocument(BOATS.vocabulary(), project(), Optional.empty()), profile);
        InspectorPanel inspector = new InspectorPanel(
                context, new LiveFindings(context.document(), check -> {}, Runnable::run, System::nanoTime));
        Map<String, Set<String>> offers = new LinkedHashMap<>();
        for (String selected : List.of("i0", "i1", "o0", "o1", "ask")) {
            context.editor().select(List.of(selected));
            Map<String, List<Component>> found = new LinkedHashMap<>();
            collect(inspector, found);
            String kind = selected.startsWith("i") ? "requirement-in-" : "requirement-out-";
            offer(found, "inspector-kind", kind, offers);
            offer(found, "inspector-match", "requirement-match-", offers);
            offer(found, "inspector-action", "requirement-action-", offers);
            offer(found, "inspector-quantity", "requirement-quantity-", offers);
            offer(found, "event-field-source", "event-source-", offers);
        }
        context.close();
        return offers;
    }

    private static void offer(
            Map<String, List<Component>> found, String field, String kind, Map<String, Set<String>> offers) {
        Set<String> of = offers.computeIfAbsent(kind, none -> new TreeSet<>());
        for (Component box : found.getOrDefault(field, List.of())) {
            JComboBox<?> choice = (JComboBox<?>) box;
            for (int i = 0; i < choice.getItemCount(); i++) {
                if (i != choice.getSelectedIndex()) {
                    of.add(word(choice.getItemAt(i)));
                }
            }
        }
    }

    private static String word(Object item) {
        return item instanceof Boolean all
                ? all ? "all" : "number"
                : item.toString().toLowerCase(Locale.ROOT).replace('_', '-');
    }

    @Test
    void profileThatNamesWhatIsNotThereIsRefusedInOneSentenceWithWhatIsLikely() throws IOException {
        Set<String> ids = open(Profile.ALL).ids();

        assertThat(ProfileIds.unknown(hiding(Set.of("net-delte")), ids))
                .contains("the profile walk names \"net-delte\", which this window does not have; likely: "
                        + String.join(
                                ", ",
                                ids.stream()
                                        .filter(id -> id.startsWith("net-"))
                                        .sorted()
                                        .limit(3)
                                        .toList()));
        assertThat(ProfileIds.unknown(locking(Set.of("panel-isues*")), ids)).isPresent();
        assertThat(ProfileIds.unknown(hiding(Set.of("net-*", "palette-sub-mission-mine", "finding-e-*")), ids))
                .isEmpty();
        assertThat(ProfileIds.unknown(hiding(ids), ids)).isEmpty();
    }

    @Test
    void theProfileOfThePageNamesOnlyWhatThereIs() throws IOException {
        Profile profile = ProfileFile.read(PROFILES.resolve("look-only.json"));

        assertThat(ProfileIds.unknown(profile, open(Profile.ALL).ids())).isEmpty();
    }

    @Test
    void theModeOfALessonIsAProfileFile(@TempDir Path folder) throws IOException {
        Lesson lesson = CourseReader.read(CourseFiles.SHIPPED, BOATS)
                .orThrow()
                .lessons()
                .get(4);
        Path file =
                Files.writeString(folder.resolve("lesson.json"), lesson.mode().profile(lesson.heading()));

        Profile profile = ProfileFile.read(file);

        assertThat(profile)
                .isEqualTo(new Profile(
                        lesson.heading(),
                        lesson.mode().hide(),
                        lesson.mode().lock(),
                        lesson.mode().keep()));
        assertThat(profile.hide()).isNotEmpty();
    }

    @Test
    void lookOnlyShowsPlansAndChangesNone() throws IOException {
        Parts parts = open(ProfileFile.read(PROFILES.resolve("look-only.json")));

        assertThat(parts.panels().all())
                .extracting(DockPanel::getPersistentID)
                .containsExactly("mission-tree", "model-view");
        assertThat(parts.context().commands().get("net-fit").isEnabled()).isTrue();
        assertThat(parts.context().commands().all())
                .extracting(command -> command.id())
                .doesNotContain("net-delete", "project-save", "undo", "plan-new")
                .contains("theme-dark", "command-search", "net-zoom-in");
    }

    private static List<String> words(Map<String, List<Component>> found) {
        return found.values().stream()
                .flatMap(List::stream)
                .filter(JLabel.class::isInstance)
                .map(label -> ((JLabel) label).getText())
                .toList();
    }

    @Test
    void secondLessonOffersBlankVerticesAloneAndSaysNothingOfRequirements() throws IOException {
        Lesson lesson = CourseReader.read(CourseFiles.SHIPPED, BOATS)
                .orThrow()
                .lessons()
                .get(1);
        Parts parts = open(LessonProfile.of(lesson));
        Map<String, List<Component>> found = walk(parts);

        assertThat(found).doesNotContainKeys("event", "inspector-add-requirement", "count-errors");
        assertThat(found).containsKeys("inspector-name", "inspector-start", "palette-search");
        assertThat(found).doesNotContainKeys("plan-tasks", "plan-variables", "project-variables", "inspector-edge");
        assertThat(words(found)).doesNotContain("Tasks", "Variables of the plan");
        assertThat(parts.context().commands().get("net-add-place").isEnabled()).isTrue();
        assertThat(parts.context().commands().all())
                .extracting(command -> command.id())
                .doesNotContain("try-start", "issue-next")
                .contains("net-connect", "project-save", "undo");
    }

    /** What a lesson's mode names and nothing has would silently be there in full. */
    @Test
    void everyPatternOfALessonsModeNamesSomethingOfTheWindow() throws IOException {
        Set<String> ids = open(Profile.ALL).ids();
        ids.addAll(Set.of("panels-fold", "course-open"));

        assertThat(CourseReader.read(CourseFiles.SHIPPED, BOATS).orThrow().lessons())
                .isNotEmpty()
                .allSatisfy(lesson -> assertThat(ProfileIds.unknown(
                                new Profile(
                                        lesson.heading(),
                                        lesson.mode().hide(),
                                        lesson.mode().lock(),
                                        lesson.mode().keep()),
                                ids))
                        .isEmpty());
    }
}
