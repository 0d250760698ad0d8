package org.sami.crw.handler;

import java.util.List;
import java.util.Objects;
import org.sami.crw.service.AllocationAlgorithm;
import org.sami.crw.service.AssemblyAlgorithm;
import org.sami.crw.service.HexagonalAssembly;
import org.sami.crw.service.SequentialSingleItemAuction;

/**
 * The algorithms that the handlers use.
 *
 * @param allocation at least one; each makes one option, the first the one that autonomy takes
 */
public record CrwServices(List<AllocationAlgorithm> allocation, AssemblyAlgorithm assembly) {
    /** Sequential single-item auction; hexagonal assembly. */
    public static final CrwServices STANDARD =
            new CrwServices(List.of(new SequentialSingleItemAuction()), new HexagonalAssembly());

    public CrwServices {
        allocation = List.copyOf(allocation);
        Objects.requireNonNull(assembly, "assembly");
        if (allocation.isEmpty()) {
            throw new IllegalArgumentException("At least one allocation algorithm is needed");
        }
    }
}
