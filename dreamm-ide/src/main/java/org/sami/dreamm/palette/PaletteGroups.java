package org.sami.dreamm.palette;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.Set;
import java.util.function.Predicate;
import org.sami.dreamm.context.DreammContext;
import org.sami.spn.sequence.EventCategory;
import org.sami.spn.vocabulary.EventType;

/** What a palette offers: blank vertices, the events of the domain, the project's plans as sub-missions, roles. Knows no Swing. */
final class PaletteGroups {
    private final DreammContext context;
    private final Predicate<PaletteItem> offered;

    /**
     * The groups of a domain and of the project that is open.
     *
     * @param offered which items are of use where the palette stands
     */
    PaletteGroups(DreammContext context, Predicate<PaletteItem> offered) {
        this.context = Objects.requireNonNull(context, "context");
        this.offered = Objects.requireNonNull(offered, "offered");
    }

    /** The ids by which profiles name all groups and items, of those that are hidden as well. */
    Set<String> profileIds() {
        Set<String> ids = new LinkedHashSet<>();
        all().forEach(group -> {
            ids.add(group.id());
            group.items().forEach(item -> {
                ids.add(item.id());
                ids.add(item.kindId());
            });
        });
        return ids;
    }

    /** The ids by which a profile can name an item: its own, that of its kind, that of its group. */
    List<String> idsOf(PaletteItem item) {
        List<String> ids = new ArrayList<>(List.of(item.id(), item.kindId()));
        all().stream()
                .filter(group -> group.items().contains(item))
                .map(PaletteGroup::id)
                .forEach(ids::add);
        return ids;
    }

    /** The groups with the items that have all the words of a text in their label, name or help; groups without one are left out. */
    List<PaletteGroup> matching(String text) {
        List<String> words = List.of(text.toLowerCase(Locale.ROOT).strip().split("\\s+"));
        List<PaletteGroup> groups = new ArrayList<>();
        for (PaletteGroup group : all()) {
            List<PaletteItem> items = group.items().stream()
                    .filter(offered)
                    .filter(item -> context.profile().shows(item.id())
                            && context.profile().shows(item.kindId()))
                    .filter(item -> matches(item, words))
                    .toList();
            if (!items.isEmpty() && context.profile().shows(group.id())) {
                groups.add(new PaletteGroup(group.id(), group.name(), items));
            }
        }
        return groups;
    }

    private static boolean matches(PaletteItem item, List<String> words) {
        String name = item instanceof PaletteItem.Event event
                ? event.type().name() + " " + String.join(" ", event.type().aliases())
                : "";
        String label = (item.label() + " " + name).toLowerCase(Locale.ROOT);
        return words.stream().allMatch(label::contains);
    }

    private List<PaletteGroup> all() {
        List<PaletteGroup> groups = new ArrayList<>();
        groups.add(new PaletteGroup(
                "palette-group-blank",
                "Blank",
                List.of(new PaletteItem.BlankPlace(), new PaletteItem.BlankTransition())));
        for (EventCategory category : context.domain().authoring().groups(context.vocabulary())) {
            List<PaletteItem> events = category.events().stream()
                    .flatMap(name -> context.vocabulary().event(name).stream())
                    .map(PaletteGroups::event)
                    .toList();
            groups.add(new PaletteGroup("palette-group-" + category.id(), category.name(), events));
        }
        groups.add(new PaletteGroup(
                "palette-group-sub-missions",
                "Sub-missions",
                context.document().project().plans().stream()
                        .map(p -> (PaletteItem) new PaletteItem.SubMission(p.id(), p.title(), p.description()))
                        .toList()));
        groups.add(new PaletteGroup(
                "palette-group-roles",
                "Roles",
                context.vocabulary().taskClasses().values().stream()
                        .map(c -> (PaletteItem) new PaletteItem.Role(c))
                        .toList()));
        return groups;
    }

    private static PaletteItem event(EventType type) {
        return new PaletteItem.Event(type);
    }
}
